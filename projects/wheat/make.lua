-- Ripe wheat on a gentle slope, in gusts (Jahrmann and Wimmer 2013, figure 12). Writes project.json and maps/ beside itself.

local size = 80
local height, wheat, tint = "ground.Terrain.height", "field.GrassField.species[wheat].density", "field.GrassField.vegetation"

project.new()
for _, name in ipairs(entity.list()) do entity.remove(name) end

entity.add("ground", { Terrain = { beyond = "fade", size = { size, size }, groundColor = { 0.13, 0.1, 0.065 }, gridSpacing = 0.5 } })
-- By the hybrid as near to the truth as by tessellated blades to 30 m, in half the time; these are there to be compared.
entity.add("field", { GrassField = {
    technique = "hybrid", cellSize = 1, minGeom = 5, maxGeom = 12, minBTF = 25, maxBTF = 40, slices = 16, sliceWidth = 512, sliceHeight = 128, farSize = 512,
    species = {
        { name = "wheat", bladesPerM2 = 900, height = 0.85, heightVariation = 0.12, width = 0.024, bend = 0.35,
          leanDeg = 9, leanVariationDeg = 8, segments = 5, smoothness = 6, texture = "maps/ear.png", clumpSize = 0.8, clumpStrength = 0.5, translucency = 0.5, gloss = 0.3,
          rootColor = { 0.16, 0.12, 0.05 }, midColor = { 0.31, 0.23, 0.085 }, tipColor = { 0.42, 0.32, 0.14 }, hueVariationDeg = 3 },
        { name = "leaves", bladesPerM2 = 350, height = 0.45, heightVariation = 0.3, width = 0.01, bend = 0.5, smoothness = 6,
          leanDeg = 18, leanVariationDeg = 20, stiffness = 0.6, segments = 4, clumpSize = 0.8, clumpStrength = 0.4, translucency = 0.6,
          rootColor = { 0.12, 0.11, 0.04 }, midColor = { 0.24, 0.2, 0.07 }, tipColor = { 0.33, 0.25, 0.1 } },
    },
}, TessellatedBlades = { maxDistance = 30, levelBy = "pixels", leastPixels = 0.5, thinning = 0 } })
entity.add("antialias", { Antialias = { antialias = "temporal" } })
entity.add("sun", { Light = { azimuthDeg = 235, elevationDeg = 24 } })
entity.add("sky", { Sky = { model = "atmosphere", turbidity = 1.5 } })
entity.add("haze", { Fog = { visibility = 4000 } })
entity.add("wind", { Wind = { strength = 0.32, azimuthDeg = 65, speed = 5, gustSize = 7, turbulence = 0.5 } })

map.create { path = height, width = 160, height = 160, type = "f32" }
map.noise(height, { scale = 40, octaves = 2, amount = 3, seed = 3, mode = "set" })
map.blur(height, 3)

-- Sown in rows too close to see, thinner in places; two tracks of the tractor.
map.create { path = wheat, width = 640, height = 640, type = "u16", value = 1 }
map.noise(wheat, { scale = 5, octaves = 4, amount = 0.25, seed = 8, mode = "multiply" })
for _, side in ipairs { -0.9, 0.9 } do
    map.polyline(wheat, { points = { { 33 + side, 82 }, { 34 + side, 55 }, { 30 + side, 30 }, { 32 + side, -2 } }, width = 0.5, soft = 0.3, value = 0.02 })
end

-- What a stalk looks like, from root to tip: a thin stem, an ear of grains in two rows, beards that stand out. Drawn on the map that
-- tints the field, before that is made.
map.create { path = tint, width = 64, height = 512, type = "u8", value = { 0.74, 0.74, 0.74, 0 } }
local function shape(points, value)  -- points: across -1 to 1, along 0 to 1
    local out = {}
    for i, p in ipairs(points) do out[i] = { (p[1] * 0.5 + 0.5) * size, p[2] * size } end
    map.polygon(tint, { points = out, value = value })
end
shape({ { -0.16, 0 }, { 0.16, 0 }, { 0.1, 0.8 }, { -0.1, 0.8 } }, { 0.66, 0.66, 0.62, 1 })
for i = 0, 8 do
    local from, side = 0.74 + 0.022 * i, i % 2 * 2 - 1
    local wide = 0.75 - 0.05 * math.abs(i - 3)
    shape({ { 0, from }, { side * wide, from + 0.02 }, { side * wide * 0.9, from + 0.045 }, { 0, from + 0.06 } }, { 0.8 - 0.03 * (i % 2), 0.78, 0.74, 1 })
    shape({ { 0, from }, { -side * wide * 0.8, from + 0.03 }, { -side * wide * 0.6, from + 0.05 }, { 0, from + 0.06 } }, { 0.68, 0.66, 0.62, 1 })
    shape({ { side * wide * 0.8, from + 0.03 }, { side * wide * 0.95, from + 0.04 }, { side * 0.85, from + 0.12 } }, { 0.86, 0.84, 0.78, 1 })
end
map.export(tint, "maps/ear.png")

-- Riper and paler on the dry rise.
map.create { path = tint, width = 256, height = 256, type = "u8", value = { 0.72, 0.6, 0.36, 0 } }
map.noise(tint, { scale = 18, octaves = 3, amount = 0.3, seed = 5, mode = "set", channels = { 4 } })
local function camera(name, x, up, z, tx, tup, tz, fov)
    entity.add(name, { Camera = { eye = { x, map.at(height, x, z) + up, z }, target = { tx, map.at(height, tx, tz) + tup, tz }, fovDeg = fov } })
end
camera("human", 40, 2.1, 72, 36, 0.6, 55, 50)
camera("low", 33.6, 1.0, 58, 33, 0.8, 40, 50)
project.saveAs(".")
