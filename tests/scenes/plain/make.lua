-- 645 x 645 plain blades in wind on 32.25 x 32.25 m, each a single triangle as seen from `eye`, over a twelfth of the
-- picture at 640 x 480. Writes project.json beside itself.

project.new()
for _, name in ipairs(entity.list()) do entity.remove(name) end

local side = 32.25
entity.add("ground", { Terrain = { size = { side, side } } })
entity.add("grass", {
    GrassField = {
        technique = "tessellated",
        cellSize = 0.75,
        species = { { name = "grass", bladesPerM2 = 400, height = 0.3, width = 0.012, clumpSize = 0, smoothness = 1 } },
    },
    TessellatedBlades = {
        levelBy = "pixels", pixelsPerQuad = 8, maxDistance = 60, thinning = 0, lowerFrom = 1, beyond = "nothing",
    },
    GrassDrawing = { shadowMask = 0, groundShadows = false },
})
entity.add("sun", { Light = {} })
entity.add("sky", { Sky = {} })
entity.add("haze", { Fog = {} })
entity.add("wind", { Wind = {} })
entity.add("eye", { Camera = { eye = { 16, 1.7, -14 }, target = { 16, 0, 16 }, fovDeg = 55 } })

project.saveAs(".")
