-- An oasis of 120 x 120 m: a lake among dunes, dense green at its shore, flowers in it, dry tussocks on the sand beyond.
-- Writes project.json, maps/ and models/ beside itself.

local size = 120
local height, ground = "ground.Terrain.height", "ground.Terrain.terrainMap"
local lush, reed, dry = "grass.GrassField.species[lush].density", "grass.GrassField.species[reed].density", "grass.GrassField.species[dry].density"
local daisies, asters = "daisies.Flowers.density", "asters.Flowers.density"
local orientation = "grass.GrassField.orientation"

---------------------------------------------------------------------------------------------------------------- scene

project.new()
for _, name in ipairs(entity.list()) do entity.remove(name) end

entity.add("ground", { Terrain = { beyond = "fade", size = { size, size }, groundColor = { 0.34, 0.25, 0.15 }, tileSize = 3, castShadows = true } })
-- Slices are sharper than by default: frames that add up smooth the grain.
entity.add("grass", { GrassField = {
    cellSize = 1, minGeom = 5, maxGeom = 11, minBTF = 26, maxBTF = 40, slices = 16, sharpness = 3, sliceWidth = 512, sliceHeight = 128, farSize = 512,
    species = {
        { name = "lush", bladesPerM2 = 4200, height = 0.3, heightVariation = 0.4, width = 0.0065, bend = 0.75,
          leanDeg = 12, leanVariationDeg = 16, segments = 4, clumpSize = 0.5, clumpStrength = 0.65, translucency = 0.8, gloss = 0.5,
          rootColor = { 0.04, 0.055, 0.018 }, midColor = { 0.06, 0.12, 0.028 }, tipColor = { 0.115, 0.17, 0.05 } },
        { name = "reed", bladesPerM2 = 130, height = 1.0, heightVariation = 0.4, width = 0.016, bend = 0.55,
          leanDeg = 6, leanVariationDeg = 11, stiffness = 2, segments = 5, clumpSize = 0.9, clumpStrength = 0.6, translucency = 0.7, gloss = 0.6,
          rootColor = { 0.07, 0.07, 0.03 }, midColor = { 0.075, 0.12, 0.035 }, tipColor = { 0.16, 0.17, 0.075 } },
        { name = "dry", bladesPerM2 = 900, height = 0.34, heightVariation = 0.4, width = 0.005, bend = 0.8,
          leanDeg = 14, leanVariationDeg = 24, segments = 4, clumpSize = 0.6, clumpStrength = 0.8, translucency = 0.5,
          rootColor = { 0.16, 0.12, 0.06 }, midColor = { 0.27, 0.21, 0.1 }, tipColor = { 0.38, 0.31, 0.17 }, hueVariationDeg = 5 },
    },
} })
entity.add("lake", { Water = { level = 0, clarity = 3.2, color = { 0.012, 0.032, 0.028 }, ripples = 0.22, rippleSize = 0.9 } })
entity.add("daisies", { Flowers = { flowersPerM2 = 26, height = 0.34, heightVariation = 0.3, headSize = 0.042, color = { 0.74, 0.72, 0.66 }, secondColor = { 0.74, 0.66, 0.42 }, maxDistance = 200 } })
entity.add("asters", { Flowers = { flowersPerM2 = 16, height = 0.4, heightVariation = 0.3, headSize = 0.05, color = { 0.36, 0.13, 0.46 }, secondColor = { 0.58, 0.2, 0.4 }, seed = 7, maxDistance = 200 } })
-- Frames that add up are as near to the truth as four samples, in less time (sward cost).
entity.add("antialias", { Antialias = { antialias = "temporal" } })
entity.add("sun", { Light = { azimuthDeg = 312, elevationDeg = 40 } })
entity.add("sky", { Sky = { model = "atmosphere", turbidity = 1.4 } })
entity.add("haze", { Fog = { visibility = 6000 } })
entity.add("wind", { Wind = { strength = 0.16, azimuthDeg = 200, speed = 3, gustSize = 9, turbulence = 0.4 } })

-- A smooth closed curve through points, as a line of many; `by` grows it about its middle.
local function curve(points, by)
    local out, n, mx, mz = {}, #points, 0, 0
    for _, p in ipairs(points) do mx, mz = mx + p[1] / n, mz + p[2] / n end
    for i = 1, n do
        local a, b, c, d = points[(i - 2) % n + 1], points[i], points[i % n + 1], points[(i + 1) % n + 1]
        for step = 0, 7 do
            local t, p = step / 8, {}
            for k = 1, 2 do
                p[k] = b[k] + t * (c[k] - a[k]) / 2 + t * t * (a[k] - 2.5 * b[k] + 2 * c[k] - d[k] / 2)
                     + t * t * t * (1.5 * (b[k] - c[k]) + (d[k] - a[k]) / 2)
            end
            out[#out + 1] = { mx + (p[1] - mx) * by, mz + (p[2] - mz) * by }
        end
    end
    return out
end
local outline = { { 40, 58 }, { 46, 46 }, { 58, 43 }, { 68, 38 }, { 80, 44 }, { 84, 56 }, { 76, 66 }, { 66, 68 }, { 58, 76 }, { 46, 72 } }
local function shore(by) return curve(outline, by) end

--------------------------------------------------------------------------------------------------------------- ground

-- Dunes to the north and east; a basin that falls gently to the shore and then to two metres under water.
map.create { path = height, width = 512, height = 512, type = "f32" }
map.noise(height, { scale = 34, octaves = 3, amount = 9, seed = 5, mode = "set" })
map.curve(height, { { 0, 0.7 }, { 3, 1.1 }, { 6, 3.4 }, { 9, 8 } })
map.blur(height, 3)
map.polygon(height, { points = shore(1.5), value = 0.75, soft = 34, opacity = 0.92 })
map.polygon(height, { points = shore(1.22), value = 0.35, soft = 16, opacity = 0.9 })
map.polygon(height, { points = shore(0.9), value = -1.9, soft = 13 })
map.blur(height, 2)
map.noise(height, { scale = 4, octaves = 3, amount = 0.12, seed = 6 })
map.noise(height, { scale = 0.9, octaves = 2, amount = 0.03, seed = 7 })

-- Wet soil at the shore, mud under water (sRGB).
map.create { path = ground, width = 1200, height = 1200, type = "u8", value = { 0.3, 0.25, 0.16, 0 } }
map.polygon(ground, { points = shore(1.3), soft = 14, value = { 0.33, 0.27, 0.17, 0.75 } })
map.polygon(ground, { points = shore(1.06), soft = 4, value = { 0.27, 0.22, 0.14, 1 } })
map.polygon(ground, { points = shore(0.85), soft = 10, value = { 0.36, 0.33, 0.24, 1 } })
map.noise(ground, { scale = 0.5, octaves = 3, amount = 0.25, seed = 21, mode = "multiply", channels = { 1, 2, 3 } })

---------------------------------------------------------------------------------------------------------------- grass

for _, path in ipairs { lush, reed, dry, daisies, asters } do map.create { path = path, width = 1200, height = 1200, type = "u16", value = 0 } end

-- Green around the lake, ragged where it meets the sand; nothing grows where the water is deep.
map.polygon(lush, { points = shore(1.36), soft = 20 })
map.noise(lush, { scale = 9, octaves = 5, amount = 0.8, seed = 31 })
map.curve(lush, { { 0.42, 0 }, { 0.78, 0.85 }, { 1, 1 } })
map.noise(lush, { scale = 1.4, octaves = 3, amount = 0.45, seed = 32, mode = "multiply" })
map.polygon(lush, { points = shore(0.985), soft = 1.6, value = 0 })

-- Reeds in stands along the water's edge, a step into it.
map.polygon(reed, { points = shore(1.035), soft = 3.5 })
map.polygon(reed, { points = shore(0.935), soft = 2.5, value = 0 })
map.noise(reed, { scale = 11, octaves = 3, amount = 1.5, seed = 33, mode = "multiply" })
map.curve(reed, { { 0.45, 0 }, { 0.62, 0.9 }, { 1, 1 } })

-- Tussocks on the sand, ever fewer.
map.noise(dry, { scale = 1.7, octaves = 3, amount = 1, seed = 34, mode = "set" })
map.curve(dry, { { 0.54, 0 }, { 0.68, 0.6 }, { 0.9, 0.9 } })
map.noise(dry, { scale = 15, octaves = 2, amount = 0.9, seed = 35, mode = "multiply" })
map.polygon(dry, { points = shore(1.2), soft = 8, value = 0 })

-- Flowers in drifts in the green.
map.polygon(daisies, { points = shore(1.28), soft = 10 })
map.noise(daisies, { scale = 6, octaves = 4, amount = 1.6, seed = 36, mode = "multiply" })
map.curve(daisies, { { 0.5, 0 }, { 0.85, 0.8 }, { 1, 1 } })
map.polygon(asters, { points = shore(1.25), soft = 9 })
map.noise(asters, { scale = 5, octaves = 4, amount = 1.6, seed = 37, mode = "multiply" })
map.curve(asters, { { 0.62, 0 }, { 0.9, 0.9 }, { 1, 1 } })
for _, path in ipairs { daisies, asters } do map.polygon(path, { points = shore(1.03), soft = 2, value = 0 }) end

-- No stalk right before the eye of the one who stands there.
for _, path in ipairs { reed, dry } do map.disc(path, { x = 57, z = 82.5, radius = 3.5, soft = 1, value = 0 }) end

map.create { path = orientation, width = 240, height = 240, type = "u16", value = 0.5 }
map.noise(orientation, { scale = 12, octaves = 2, amount = 0.9, seed = 41, channels = { 1 } })
map.noise(orientation, { scale = 12, octaves = 2, amount = 0.9, seed = 42, channels = { 2 } })

-------------------------------------------------------------------------------------------------------------- objects

local bark, ring, frond, oldFrond, stone = { 0.13, 0.095, 0.065 }, { 0.1, 0.07, 0.045 }, { 0.05, 0.095, 0.022 }, { 0.16, 0.12, 0.05 }, { 0.2, 0.165, 0.125 }

-- The way that a shape's y axis points after its turn about x, then y.
local function along(pitch, heading)
    local a, b = math.rad(pitch), math.rad(heading)
    return math.sin(a) * math.sin(b), math.cos(a), math.sin(a) * math.cos(b)
end
local function stick(shapes, x, y, z, length, radius, top, pitch, heading, color, sides)
    shapes[#shapes + 1] = { shape = "cylinder", at = { x, y, z }, radius = radius, top = top, height = length, turn = { pitch, heading, 0 }, color = color, sides = sides or 10 }
    local dx, dy, dz = along(pitch, heading)
    return x + dx * length, y + dy * length, z + dz * length
end

-- A date palm: a trunk in rings that leans and rights itself, fronds that arch over, each with leaflets to both sides.
local function palm(name, tall, leans, seed)
    local shapes, x, y, z = {}, 0, -0.4, 0
    local rings = math.floor(tall / 0.45)
    for i = 0, rings do
        local pitch = leans * (1 - 1.3 * i / rings)
        local r = 0.21 - 0.08 * i / rings + (i == 0 and 0.07 or 0)
        stick(shapes, x, y, z, 0.1, r * 1.12, r * 0.98, pitch, 40 * seed, ring)
        x, y, z = stick(shapes, x, y, z, 0.47, r, r * 0.97, pitch, 40 * seed, bark)
    end
    local fronds = 26
    for i = 1, fronds do
        local layer = (i * 7 % fronds) / fronds
        local heading, pitch, length = i * 137.5 + seed * 50, 18 + 78 * layer, 2.1 + 0.5 * ((i * 5 + seed) % 7) / 7
        local px, py, pz, color = x, y - 0.05, z, layer > 0.88 and oldFrond or frond
        for part = 0, 6 do
            local p = pitch + part * (9 + 5 * layer)
            local nx, ny, nz = stick(shapes, px, py, pz, length / 7, 0.028 - 0.003 * part, 0.025 - 0.003 * part, p, heading, color, 4)
            for k = 0, 2 do
                local t, reach = k / 3, 0.62 * math.sin(math.rad(24 + 20 * (part + k / 3)))
                for side = -1, 1, 2 do
                    stick(shapes, px + (nx - px) * t, py + (ny - py) * t, pz + (nz - pz) * t, reach, 0.022, 0.003, math.min(p + 24, 150), heading + side * 58, color, 3)
                end
            end
            px, py, pz = nx, ny, nz
        end
    end
    mesh.write("models/" .. name .. ".glb", shapes)
end
palm("palm1", 6.4, 14, 1)
palm("palm2", 4.6, 20, 2)
palm("palm3", 7.8, 9, 3)
for i, half in ipairs { { 1.15, 0.75, 0.9 }, { 0.7, 0.42, 0.6 }, { 0.36, 0.26, 0.3 } } do
    mesh.write("models/rock" .. i .. ".glb", { { shape = "ball", at = { 0, half[2] * 0.35, 0 }, size = half, rough = 0.2, seed = 60 + i, color = stone } })
end

local count = 0
local function put(model, x, z, heading, scale)
    count = count + 1
    entity.add(string.format("%s-%02d", model, count), {
        Transform = { position = { x, 0, z } },
        StaticMesh = { file = "models/" .. model .. ".glb", rotationDeg = { 0, heading or 0, 0 }, scale = scale or 1 },
    })
end
for i, at in ipairs { { 52, 39.5 }, { 49, 38 }, { 61, 35.5 }, { 74, 34.5 }, { 76.5, 36.5 }, { 88, 50 }, { 37, 54 }, { 35, 60 }, { 84, 68 }, { 44, 79 }, { 66, 31 } } do
    put("palm" .. (i * 5 % 3 + 1), at[1], at[2], i * 83 % 360, 0.85 + 0.3 * (i * 5 % 7) / 7)
end
put("rock1", 63.5, 42.2, 20)
put("rock2", 65.2, 42.6, 140)
put("rock3", 62.1, 43.4, 80)
put("rock2", 57.2, 72.6, 250)
put("rock3", 58.4, 71.9, 10)
put("rock1", 81.8, 58.2, 200, 0.8)
put("rock2", 92, 82, 30, 1.6)

-------------------------------------------------------------------------------------------------------------- cameras

local function above(x, z, metres) return { x, math.max(map.at(height, x, z), 0) + metres, z } end
entity.add("whole", { Camera = { eye = { 66, 27, 112 }, target = { 61, 0, 58 }, fovDeg = 55 } })
entity.add("human", { Camera = { eye = above(57, 82.5, 1.7), target = { 63, 0.4, 50 }, fovDeg = 58 } })
entity.add("low", { Camera = { eye = above(61, 65.5, 0.42), target = { 66, 0.75, 44 }, fovDeg = 55 } })

project.saveAs(".")
bake.ambientOcclusion { samples = 64, size = 256 }
project.save()
