-- The world of large_world.sh: mountains of 16,384 x 16,384 heights of 16 bits, a metre apart, and grass on them.
project.new("world")
edit.group("a land of 16 km", function()
    entity.set("ground.Terrain.gridSpacing", 1)
    entity.set("ground.Terrain.lodDistance", 60)
    entity.set("ground.Terrain.size", { 16384, 16384 })
    entity.set("ground.Terrain.heightRange", { 0, 1200 })
end)
map.create { path = "ground.Terrain.height", width = 16384, height = 16384, type = "u16" }
map.noise("height", { scale = 2500, octaves = 8, amount = 1200, mode = "set" })
local ground = map.at("height", 8000, 8000)
entity.set("camera.Camera.eye", { 8000, ground + 40, 8000 })
entity.set("camera.Camera.target", { 8100, ground + 20, 8200 })
project.save()
print "made"
