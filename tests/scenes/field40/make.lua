-- The plainest field: 40 x 40 m of flat ground, 1000 blades a square metre, one camera at eye height.
-- Writes project.json and maps/ beside itself.

project.new()
for _, name in ipairs(entity.list()) do entity.remove(name) end

entity.add("ground", { Terrain = { size = { 40, 40 } } })
entity.add("lawn", { GrassField = { species = { { name = "grass", bladesPerM2 = 1000 } } } })
entity.add("sun", { Light = { azimuthDeg = 135, elevationDeg = 42 } })
entity.add("sky", { Sky = {} })
entity.add("haze", { Fog = {} })
entity.add("eye", { Camera = { eye = { 20, 1.7, 2 }, target = { 20, 0.2, 14 }, fovDeg = 55 } })
map.create { path = "lawn.GrassField.species[grass].density", width = 400, height = 400, value = 1 }

project.saveAs(".")
