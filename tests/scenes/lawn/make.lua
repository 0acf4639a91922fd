-- A lawn of 20 x 20 m with 10,000 blades a square metre, by the hybrid with its shadows, from a person's eyes in a
-- corner. Writes project.json beside itself.

project.new()
for _, name in ipairs(entity.list()) do entity.remove(name) end

entity.add("ground", { Terrain = { size = { 20, 20 } } })
entity.add("grass", {
    GrassField = { species = { { name = "grass", bladesPerM2 = 10000, height = 0.08, width = 0.004 } } },
    HybridTiers = { minGeom = 2, maxGeom = 4, minBTF = 7, maxBTF = 11 },
})
entity.add("sun", { Light = {} })
entity.add("sky", { Sky = {} })
entity.add("haze", { Fog = {} })
entity.add("eye", { Camera = { eye = { 1, 1.7, 1 }, target = { 10, 0, 10 }, fovDeg = 55 } })

project.saveAs(".")
