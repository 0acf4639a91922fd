-- A grove of 576 tiles and some 2,300 trees, as in figure 12 of Decaudin and Neyret 2004, with a meadow and a pond between: one may walk through it.
-- Writes project.json and maps/ beside itself.

local size = 252
local height, ground = "land.Terrain.height", "land.Terrain.terrainMap"
local trees, meadow = "trees.Forest.density", "grass.GrassField.species[meadow].density"
local pond, glade = { 118, 150 }, { 96, 118 }

project.new()
for _, name in ipairs(entity.list()) do entity.remove(name) end

entity.add("land", { Terrain = { size = { size, size }, groundColor = { 0.075, 0.068, 0.036 }, gridSpacing = 1, lodDistance = 60, castShadows = true } })
entity.add("trees", { Forest = {
    perHectare = 420, distance = 3.4, tileSize = 16, meshesTo = 55, seed = 2,
    species = {
        { name = "birch", kind = "birch", share = 0.4, height = 11, crown = 0.36, size = { 0.75, 1.15 }, leafColor = { 0.09, 0.14, 0.034 },
          barkColor = { 0.42, 0.41, 0.37 }, leaves = 3000 },
        { name = "oak", kind = "broadleaf", share = 0.35, height = 9.5, crown = 0.5, size = { 0.75, 1.15 }, leafColor = { 0.068, 0.122, 0.029 }, leaves = 3000, seed = 2 },
        { name = "spruce", kind = "conifer", share = 0.25, height = 13, crown = 0.31, size = { 0.6, 1.15 }, leafColor = { 0.042, 0.094, 0.03 }, leaves = 3000, seed = 3 },
    },
} })
entity.add("grass", { GrassField = {
    cellSize = 1, minGeom = 5, maxGeom = 12, minBTF = 14, maxBTF = 26, slices = 16, sliceWidth = 256, farSize = 256,
    species = {
        { name = "meadow", bladesPerM2 = 900, height = 0.3, heightVariation = 0.3, width = 0.006, bend = 0.6, leanDeg = 12, leanVariationDeg = 14,
          segments = 3, clumpSize = 0.4, clumpStrength = 0.5, translucency = 0.7, gloss = 0.3,
          rootColor = { 0.05, 0.06, 0.02 }, midColor = { 0.08, 0.125, 0.035 }, tipColor = { 0.15, 0.165, 0.06 } },
    },
} })
-- Frames that add up: the meadow nearer to the truth, and all in half to four fifths of the time (sward cost).
entity.add("antialias", { Antialias = { antialias = "temporal" } })
entity.add("sun", { Light = { azimuthDeg = 225, elevationDeg = 36 } })
entity.add("sky", { Sky = { turbidity = 3 } })
entity.add("haze", { Fog = { visibility = 3000 } })

-- Gentle ground with a hollow for the pond.
map.create { path = height, width = 512, height = 512, type = "f32" }
map.noise(height, { scale = 90, octaves = 4, amount = 9, seed = 3, mode = "set" })
map.blur(height, 2)
map.disc(height, { x = pond[1], z = pond[2], radius = 26, soft = 44, mode = "add", value = -6 })
local level = map.at(height, pond[1], pond[2]) + 1.6
entity.add("pond", { Water = { level = level, clarity = 1.2, reflection = 0.5, ripples = 0.4 } })

-- Forest but for the meadow around the pond, with a ragged edge.
map.create { path = trees, width = 512, height = 512, type = "u16", value = 1 }
map.disc(trees, { x = glade[1], z = glade[2], radius = 52, soft = 30, mode = "set", value = 0 })
map.disc(trees, { x = pond[1], z = pond[2], radius = 42, soft = 22, mode = "set", value = 0 })
map.noise(trees, { scale = 30, octaves = 4, amount = 0.5, seed = 7, mode = "multiply" })
map.curve(trees, { { 0, 0 }, { 0.45, 0.06 }, { 0.6, 0.95 }, { 1, 1 } })
map.create { path = meadow, width = 512, height = 512, type = "u16", value = 0.15 }
map.disc(meadow, { x = glade[1], z = glade[2], radius = 58, soft = 40, mode = "set", value = 1 })
map.disc(meadow, { x = pond[1], z = pond[2], radius = 44, soft = 24, mode = "set", value = 1 })
map.noise(meadow, { scale = 9, octaves = 4, amount = 0.5, seed = 8, mode = "multiply" })
for x = -30, 30 do
    for z = -30, 30 do
        local at = { pond[1] + x, pond[2] + z }
        if map.at(height, at[1], at[2]) < level + 0.12 then
            map.disc(meadow, { x = at[1], z = at[2], radius = 0.8, soft = 0.6, mode = "set", value = 0 })
            map.disc(trees, { x = at[1], z = at[2], radius = 1.5, soft = 1, mode = "set", value = 0 })
        end
    end
end

local function above(x, z, metres) return { x, map.at(height, x, z) + metres, z } end
entity.add("meadow", { Camera = { eye = above(70, 78, 1.7), target = above(122, 150, 3), fovDeg = 60 } })
entity.add("human", { Camera = { eye = above(160, 176, 1.8), target = above(90, 120, 3), fovDeg = 60 } })
entity.add("air", { Camera = { eye = { 126, 75, 340 }, target = { 126, 0, 120 }, fovDeg = 48 } })

project.saveAs(".")
