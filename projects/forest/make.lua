-- Mountains under forest, about a square kilometre: 9,212 tiles and some 37,000 trees, as in figure 12 of Decaudin and Neyret 2004.
-- Writes project.json and maps/ beside itself.

local size = 1010
local height, trees = "land.Terrain.height", "trees.Forest.density"

project.new()
for _, name in ipairs(entity.list()) do entity.remove(name) end

entity.add("land", { Terrain = { size = { size, size }, groundColor = { 0.062, 0.062, 0.03 }, gridSpacing = 2, lodDistance = 150, castShadows = true } })
entity.add("trees", { Forest = {
    perHectare = 420, distance = 3.4, tileSize = 16, meshesTo = 70, slopeDeg = { 0, 42 }, seed = 4,
    species = {
        { name = "spruce", kind = "conifer", share = 0.55, height = 13, crown = 0.3, size = { 0.65, 1.2 }, leafColor = { 0.04, 0.092, 0.028 } },
        { name = "oak", kind = "broadleaf", share = 0.27, height = 9, crown = 0.5, size = { 0.75, 1.15 }, leafColor = { 0.066, 0.12, 0.028 }, seed = 2 },
        { name = "birch", kind = "birch", share = 0.18, height = 11, crown = 0.34, size = { 0.7, 1.1 }, leafColor = { 0.09, 0.135, 0.032 },
          barkColor = { 0.42, 0.41, 0.37 }, seed = 3 },
    },
} })
entity.add("sun", { Light = { azimuthDeg = 130, elevationDeg = 38 } })
entity.add("sky", { Sky = { turbidity = 3 } })
entity.add("haze", { Fog = { visibility = 9000 } })

-- Ridges and valleys of some 180 m.
map.create { path = height, width = 512, height = 512, type = "f32" }
map.noise(height, { scale = 420, octaves = 6, amount = 230, seed = 5, mode = "set" })
map.blur(height, 2)

-- Forest nearly everywhere; glades, and bare heights.
map.create { path = trees, width = 512, height = 512, type = "u16", value = 1 }
map.noise(trees, { scale = 95, octaves = 4, amount = 1, seed = 9, mode = "set" })
map.curve(trees, { { 0, 0 }, { 0.3, 0 }, { 0.36, 0.95 }, { 1, 1 } })

local function above(x, z, metres) return { x, map.at(height, x, z) + metres, z } end
entity.add("valley", { Camera = { eye = above(120, 900, 95), target = above(520, 420, 0), fovDeg = 50 } })
entity.add("human", { Camera = { eye = above(420, 700, 1.8), target = above(500, 640, 6), fovDeg = 60, exposure = 0.5 } })
entity.add("ridge", { Camera = { eye = above(500, 505, 26), target = above(860, 160, 0), fovDeg = 55 } })
entity.add("whole", { Camera = { eye = { 505, 560, 1480 }, target = { 505, 60, 480 }, fovDeg = 45 } })

project.saveAs(".")
