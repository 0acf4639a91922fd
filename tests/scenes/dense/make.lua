-- 645 x 645 blades of six, three or one quads by their length on screen, on 6.45 x 6.45 m: over half of the picture from
-- `eye` at 640 x 480, and many layers deep. Writes project.json beside itself.

project.new()
for _, name in ipairs(entity.list()) do entity.remove(name) end

local side = 6.45
entity.add("ground", { Terrain = { size = { side, side } } })
entity.add("grass", {
    GrassField = {
        technique = "tessellated",
        cellSize = 0.15,
        species = { { name = "grass", bladesPerM2 = 10000, height = 0.3, width = 0.013, clumpSize = 0, smoothness = 6 } },
    },
    TessellatedBlades = {
        levelBy = "pixels", pixelsPerQuad = 16, maxDistance = 60, thinning = 0, lowerFrom = 1, beyond = "nothing",
    },
    GrassDrawing = { shadowMask = 0, groundShadows = false },
})
entity.add("sun", { Light = {} })
entity.add("sky", { Sky = {} })
entity.add("haze", { Fog = {} })
entity.add("wind", { Wind = {} })
entity.add("eye", { Camera = { eye = { 3.2, 1.1, -0.4 }, target = { 3.2, 0.3, 3 }, fovDeg = 55 } })

project.saveAs(".")
