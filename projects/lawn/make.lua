-- A lawn of 8 x 8 patches of 1 m, ray-traced: grass of moderate height with 16 slices a side, and a bed of short, dense
-- turf with 32, with objects standing in both (Habel, Wimmer and Jeschke 2007, figures 1, 7 and 8).
-- Writes project.json, maps/ and models/ beside itself.

local size = 8
local height, ground = "ground.Terrain.height", "ground.Terrain.terrainMap"
local grown, mown = "grass.GrassField.species[meadow].density", "turf.GrassField.species[turf].density"
local tint = "grass.GrassField.vegetation"

project.new()
for _, name in ipairs(entity.list()) do entity.remove(name) end

entity.add("ground", { Terrain = { beyond = "fade", size = { size, size }, groundColor = { 0.1, 0.08, 0.05 }, gridSpacing = 0.25, castShadows = true } })
entity.add("grass", { GrassField = {
    -- Drawn with four samples a pixel: finer images would be grain.
    technique = "raytraced", cellSize = 1, slices = 16, sharpness = 0.5, sliceWidth = 512, sliceHeight = 128, farSize = 512,
    species = { {
        name = "meadow", bladesPerM2 = 2600, height = 0.2, heightVariation = 0.35, width = 0.005, bend = 0.6, leanDeg = 11,
        leanVariationDeg = 15, segments = 4, clumpSize = 0.45, clumpStrength = 0.5, translucency = 0.75, gloss = 0.45,
        rootColor = { 0.045, 0.06, 0.02 }, midColor = { 0.06, 0.12, 0.03 }, tipColor = { 0.11, 0.165, 0.045 },
    } },
} })
entity.add("turf", { GrassField = {
    technique = "raytraced", cellSize = 1, slices = 32, sharpness = 0.5, sliceWidth = 512, sliceHeight = 64, farSize = 512, seed = 5,
    species = { {
        name = "turf", bladesPerM2 = 14000, height = 0.05, heightVariation = 0.25, width = 0.003, bend = 0.3, leanDeg = 14,
        leanVariationDeg = 10, segments = 3, clumpSize = 0.3, clumpStrength = 0.35, translucency = 0.6, gloss = 0.45,
        rootColor = { 0.04, 0.06, 0.018 }, midColor = { 0.05, 0.118, 0.028 }, tipColor = { 0.08, 0.15, 0.042 },
    } },
} })
entity.add("sun", { Light = { azimuthDeg = 225, elevationDeg = 38 } })
entity.add("sky", { Sky = { model = "atmosphere", turbidity = 1.3 } })
entity.add("haze", { Fog = { visibility = 6000 } })
entity.add("wind", { Wind = { strength = 0.14, azimuthDeg = 70, speed = 3, gustSize = 5, turbulence = 0.45 } })

-- Gentle ground.
map.create { path = height, width = 128, height = 128, type = "f32" }
map.noise(height, { scale = 5, octaves = 2, amount = 0.5, seed = 4, mode = "set" })
map.blur(height, 1)

-- A bed of turf, bounded by a soft, wavy edge, with a strip of soil around it.
local cx, cz, radius = 4.7, 4.5, 1.6
local function beyond(x, z)  -- metres outside the bed; negative within
    local dx, dz = x - cx, (z - cz) * 1.15
    local angle = math.atan(dz, dx)
    return math.sqrt(dx * dx + dz * dz) - radius - 0.18 * math.sin(3 * angle + 0.6) - 0.07 * math.sin(7 * angle)
end
local function share(metres, over) return math.max(0, math.min(1, 0.5 + metres / over)) end
map.create { path = grown, width = 512, height = 512, type = "u16", value = 1 }
map.fill(grown, function(x, z) return share(beyond(x, z) - 0.09, 0.08) end)
map.create { path = mown, width = 512, height = 512, type = "u16", value = 1 }
map.fill(mown, function(x, z) return share(-beyond(x, z) - 0.04, 0.06) end)

map.create { path = tint, width = 256, height = 256, type = "u8", value = { 0.5, 0.47, 0.24, 0 } }
map.noise(tint, { scale = 2, octaves = 4, amount = 0.6, seed = 9, mode = "set", channels = { 4 } })
map.curve(tint, { { 0.4, 0 }, { 0.75, 0.3 } }, { channels = { 4 } })

-- Objects that stand in the grass: stones at the bed's edge, a ball on the turf, a post in the meadow.
local stone = { 0.14, 0.135, 0.12 }
for i, s in ipairs { { 0.32, 0.24, 0.28 }, { 0.2, 0.17, 0.23 } } do
    mesh.write("models/stone" .. i .. ".glb", { { shape = "ball", at = { 0, s[2] * 0.35, 0 }, size = s, rough = 0.18, seed = 30 + i, color = stone } })
end
mesh.write("models/ball.glb", { { shape = "ball", at = { 0, 0.1, 0 }, size = { 0.11, 0.11, 0.11 }, color = { 0.55, 0.03, 0.03 } } })
mesh.write("models/post.glb", {
    { shape = "cylinder", at = { 0, -0.2, 0 }, radius = 0.055, top = 0.05, height = 1.1, color = { 0.11, 0.065, 0.035 }, sides = 14 },
    { shape = "box", at = { 0, 0.66, 0.05 }, size = { 0.46, 0.17, 0.03 }, color = { 0.14, 0.085, 0.045 } },
})
local function stand(name, model, x, z, turn)
    entity.add(name, { Transform = { position = { x, 0, z } }, StaticMesh = { file = "models/" .. model .. ".glb", rotationDeg = { 0, turn, 0 } } })
end
for i, at in ipairs { { 3.1, 3.6, 1 }, { 3.55, 3.1, 2 }, { 6.3, 5.7, 1 }, { 1.7, 5.6, 2 }, { 6.6, 2.5, 1 } } do stand("stone" .. i, "stone" .. at[3], at[1], at[2], 71 * i % 360) end
stand("ball", "ball", 4.4, 3.9, 0)
stand("post", "post", 2.3, 3.3, 20)

local function above(x, z, metres) return { x, map.at(height, x, z) + metres, z } end
entity.add("whole", { Camera = { eye = { 4, 3.2, -3.2 }, target = above(4.1, 3.6, 0), fovDeg = 55 } })
entity.add("human", { Camera = { eye = above(2.9, 0.1, 1.7), target = above(4.1, 4.2, 0.1), fovDeg = 55 } })
entity.add("low", { Camera = { eye = above(3.9, 1.7, 0.3), target = above(4.5, 4.4, 0.08), fovDeg = 55 } })
project.saveAs(".")
