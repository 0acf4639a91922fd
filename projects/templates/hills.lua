-- Meadow with hills: knee-high grass in clumps, shorter on the tops, daisies in drifts, wind.
-- 120 m, 14 m of relief

local height, tall, short = "ground.Terrain.height", "grass.GrassField.species[meadow].density", "grass.GrassField.species[lawn].density"
local daisies = "daisies.Flowers.density"
local points = math.max(128, math.min(1024, math.floor(size * 2)))
local texels = 512
while texels < 5 * size and texels < 4096 do texels = 2 * texels end

entity.remove("lawn")
entity.set("ground.Terrain.size", { size, size })
entity.set("ground.Terrain.groundColor", { 0.1, 0.082, 0.05 })
entity.add("grass", { GrassField = { cellSize = 1, species = {
    { name = "meadow", bladesPerM2 = 2400, height = 0.42, heightVariation = 0.35, width = 0.006, bend = 0.65, leanDeg = 11, leanVariationDeg = 16,
      segments = 4, smoothness = 6, clumpSize = 0.45, clumpStrength = 0.6, translucency = 0.8, gloss = 0.4,
      rootColor = { 0.05, 0.062, 0.02 }, midColor = { 0.075, 0.125, 0.034 }, tipColor = { 0.15, 0.17, 0.06 } },
    { name = "lawn", bladesPerM2 = 6000, height = 0.12, heightVariation = 0.3, width = 0.0045, bend = 0.55, leanDeg = 11, leanVariationDeg = 15,
      segments = 3, smoothness = 4, clumpSize = 0.35, clumpStrength = 0.5, translucency = 0.6, gloss = 0.5 },
} } })
entity.add("daisies", { Flowers = { flowersPerM2 = 12, height = 0.42, heightVariation = 0.3, headSize = 0.045 } })
entity.add("wind", { Wind = { strength = 0.2, gustSize = 9 } })
entity.set("sun.Light.azimuthDeg", 250)
entity.set("sun.Light.elevationDeg", 36)

map.create { path = height, width = points, height = points, type = "f32" }
map.noise(height, { scale = math.max(16, size / 2.5), octaves = 3, amount = relief, seed = 6, mode = "set" })
map.blur(height, size / points * 4)

-- Tall in the hollows and on slopes, short grass on the tops; both ragged where they meet.
map.create { path = tall, width = texels, height = texels, type = "u16", value = 1 }
map.create { path = short, width = texels, height = texels, type = "u16", value = 1 }
map.noise(tall, { scale = 9, octaves = 4, amount = 1, seed = 11, mode = "set" })
map.curve(tall, { { 0.3, 0.25 }, { 0.5, 0.9 }, { 1, 1 } })
map.copy(short, tall)
map.curve(short, { { 0, 1 }, { 0.6, 0.5 }, { 1, 0.25 } })
map.create { path = daisies, width = texels, height = texels, type = "u16", value = 0 }
map.noise(daisies, { scale = 14, octaves = 4, amount = 1, seed = 12, mode = "set" })
map.curve(daisies, { { 0.52, 0 }, { 0.72, 0.8 }, { 1, 1 } })

local function above(x, z, metres) return { x, map.at(height, x, z) + metres, z } end
entity.set("camera.Camera.eye", above(size * 0.46, size * 0.72, 1.9))
entity.set("camera.Camera.target", above(size * 0.55, size * 0.3, 0.6))
