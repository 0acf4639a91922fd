-- Pond and reed: a pond in a hollow, reed at its edge, lush grass around it, flowers.
-- 60 m, 3 m of relief

local height, ground = "ground.Terrain.height", "ground.Terrain.terrainMap"
local lush, reed, daisies = "grass.GrassField.species[lush].density", "grass.GrassField.species[reed].density", "daisies.Flowers.density"
local points = math.max(128, math.min(1024, math.floor(size * 4)))
local texels = 512
while texels < 6 * size and texels < 4096 do texels = 2 * texels end

entity.remove("lawn")
entity.set("ground.Terrain.size", { size, size })
entity.set("ground.Terrain.groundColor", { 0.11, 0.09, 0.055 })
entity.add("grass", { GrassField = { cellSize = 1, species = {
    { name = "lush", bladesPerM2 = 3600, height = 0.26, heightVariation = 0.4, width = 0.006, bend = 0.7, leanDeg = 12, leanVariationDeg = 16,
      segments = 4, smoothness = 5, clumpSize = 0.5, clumpStrength = 0.6, translucency = 0.8, gloss = 0.5,
      rootColor = { 0.04, 0.055, 0.018 }, midColor = { 0.06, 0.12, 0.028 }, tipColor = { 0.115, 0.17, 0.05 } },
    { name = "reed", bladesPerM2 = 160, height = 1.6, heightVariation = 0.25, width = 0.02, bend = 0.4, leanDeg = 5, leanVariationDeg = 9, stiffness = 2,
      segments = 6, smoothness = 8, clumpSize = 0.9, clumpStrength = 0.5, translucency = 0.7, gloss = 0.6,
      rootColor = { 0.09, 0.08, 0.035 }, midColor = { 0.075, 0.125, 0.035 }, tipColor = { 0.16, 0.175, 0.07 } },
} } })
entity.add("daisies", { Flowers = { flowersPerM2 = 16, height = 0.32, headSize = 0.042 } })
entity.add("pond", { Water = { level = 0, clarity = 2.4, ripples = 0.22, rippleSize = 0.8 } })
entity.add("wind", { Wind = { strength = 0.14, gustSize = 8 } })
entity.set("sun.Light.azimuthDeg", 300)
entity.set("sun.Light.elevationDeg", 38)

-- The shore: a round that is not quite one.
local middle, radius = size / 2, size * 0.2
local function shore(by)
    local out = {}
    for i = 0, 47 do
        local a = 2 * math.pi * i / 48
        local r = by * radius * (1 + 0.22 * math.sin(2 * a + 0.7) + 0.1 * math.sin(3 * a + 2))
        out[#out + 1] = { middle + 1.25 * r * math.cos(a), middle - size * 0.04 + r * math.sin(a) }
    end
    return out
end

map.create { path = height, width = points, height = points, type = "f32" }
map.noise(height, { scale = size / 3, octaves = 3, amount = relief, seed = 8, mode = "set" })
map.curve(height, { { 0, 0.35 }, { math.max(relief, 0.01), 0.35 + relief } })
map.blur(height, size / 60)
map.polygon(height, { points = shore(1.5), value = 0.4, soft = radius, opacity = 0.9 })
map.polygon(height, { points = shore(0.85), value = -math.max(0.8, radius / 8), soft = radius * 0.55 })
map.blur(height, size / 120)

map.create { path = ground, width = 1024, height = 1024, type = "u8", value = { 0.3, 0.25, 0.16, 0 } }
map.polygon(ground, { points = shore(1.1), soft = radius * 0.2, value = { 0.3, 0.27, 0.18, 1 } })

for _, path in ipairs { lush, reed, daisies } do map.create { path = path, width = texels, height = texels, type = "u16", value = 0 } end
map.noise(lush, { scale = 6, octaves = 4, amount = 1, seed = 31, mode = "set" })
map.curve(lush, { { 0.1, 0.35 }, { 0.45, 1 } })
map.polygon(lush, { points = shore(0.97), soft = 1, value = 0 })
map.polygon(reed, { points = shore(1.1), soft = 1.5 })
map.polygon(reed, { points = shore(0.9), soft = 1.5, value = 0 })
map.noise(reed, { scale = size / 6, octaves = 3, amount = 1.6, seed = 33, mode = "multiply" })
map.curve(reed, { { 0.4, 0 }, { 0.6, 0.9 }, { 1, 1 } })
map.polygon(daisies, { points = shore(1.9), soft = radius * 0.6 })
map.noise(daisies, { scale = 5, octaves = 4, amount = 1.6, seed = 36, mode = "multiply" })
map.curve(daisies, { { 0.5, 0 }, { 0.85, 0.8 }, { 1, 1 } })
map.polygon(daisies, { points = shore(1.1), soft = 1.5, value = 0 })

-- No reed before the eye.
local ex, ez = middle - size * 0.12, middle + size * 0.3
map.disc(reed, { x = ex, z = ez - size * 0.08, radius = size * 0.1, soft = 2, value = 0 })
local function above(x, z, metres) return { x, math.max(0, map.at(height, x, z)) + metres, z } end
entity.set("camera.Camera.eye", above(ex, ez, 1.7))
entity.set("camera.Camera.target", { middle + size * 0.05, 0, middle - size * 0.08 })
