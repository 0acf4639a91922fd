-- A park of 120 x 120 m: rolling ground, gravel paths, two ponds, a mown lawn with soft edges, and meadows of
-- tall grass. Writes project.json and maps/ beside itself.

local size = 120
local lawn, meadow = "grass.GrassField.species[lawn].density", "grass.GrassField.species[meadow].density"
local height, ground = "ground.Terrain.height", "ground.Terrain.terrainMap"
local orientation, tint = "grass.GrassField.orientation", "grass.GrassField.vegetation"

---------------------------------------------------------------------------------------------------------------- scene

project.new()
for _, name in ipairs(entity.list()) do entity.remove(name) end

entity.add("ground", { Terrain = { beyond = "fade", size = { size, size }, groundColor = { 0.11, 0.085, 0.055 } } })
entity.add("grass", { GrassField = {
    cellSize = 1, minGeom = 2.5, maxGeom = 6, minBTF = 14, maxBTF = 24, slices = 20, sliceWidth = 512, farSize = 512,
    species = {
        { name = "lawn", bladesPerM2 = 12000, height = 0.075, heightVariation = 0.25, width = 0.0035, bend = 0.45,
          leanDeg = 10, leanVariationDeg = 12, segments = 2, clumpSize = 0.35, clumpStrength = 0.5,
          translucency = 0.6, gloss = 0.6 },
        { name = "meadow", bladesPerM2 = 1500, height = 0.32, heightVariation = 0.25, width = 0.005, bend = 0.7,
          leanDeg = 12, leanVariationDeg = 14, segments = 4, clumpSize = 0.4, clumpStrength = 0.6,
          translucency = 0.8, gloss = 0.4,
          rootColor = { 0.05, 0.06, 0.02 }, midColor = { 0.08, 0.125, 0.035 }, tipColor = { 0.16, 0.17, 0.06 } },
    },
} })
-- Blades are thinner than a pixel: frames that add up are nearer to the truth than four samples, and quicker (sward cost).
entity.add("antialias", { Antialias = { antialias = "temporal" } })
entity.add("sun", { Light = { azimuthDeg = 105, elevationDeg = 38 } })
entity.add("sky", { Sky = { model = "atmosphere", turbidity = 1.5 } })
entity.add("haze", { Fog = { visibility = 6000 } })

-- A smooth curve through points, as a line of many.
local function curve(points, closed)
    local out, n = {}, #points
    local function point(i)
        if closed then return points[(i - 1) % n + 1] end
        return points[math.max(1, math.min(n, i))]
    end
    for i = 1, closed and n or n - 1 do
        local a, b, c, d = point(i - 1), point(i), point(i + 1), point(i + 2)
        for step = 0, 7 do
            local t, p = step / 8, {}
            for k = 1, 2 do
                p[k] = b[k] + t * (c[k] - a[k]) / 2 + t * t * (a[k] - 2.5 * b[k] + 2 * c[k] - d[k] / 2)
                     + t * t * t * (1.5 * (b[k] - c[k]) + (d[k] - a[k]) / 2)
            end
            out[#out + 1] = p
        end
    end
    if not closed then out[#out + 1] = points[n] end
    return out
end

local ponds = {
    { centre = { 38, 44 }, hollow = 19, deep = 1, shore = curve({ { 27, 42 }, { 33, 34 }, { 43, 35 }, { 50, 41 }, { 47, 51 }, { 38, 54 }, { 30, 51 } }, true) },
    { centre = { 84, 82 }, hollow = 15, deep = 1.2, shore = curve({ { 77, 80 }, { 82, 75 }, { 90, 77 }, { 92, 84 }, { 86, 89 }, { 79, 87 } }, true) },
}
local paths = {
    { width = 2.6, points = curve { { -4, 68 }, { 14, 63 }, { 30, 66 }, { 48, 62 }, { 62, 68 }, { 78, 64 }, { 98, 56 }, { 124, 60 } } },
    { width = 1.9, points = curve { { 62, 68 }, { 60, 84 }, { 68, 98 }, { 64, 110 }, { 70, 124 } } },
    { width = 1.9, points = curve { { 48, 62 }, { 57, 48 }, { 56, 34 }, { 66, 20 }, { 64, -4 } } },
}
local meadows = {
    curve({ { 70, 14 }, { 92, 8 }, { 112, 18 }, { 110, 38 }, { 92, 46 }, { 74, 40 } }, true),
    curve({ { 8, 78 }, { 26, 74 }, { 48, 78 }, { 54, 96 }, { 40, 112 }, { 16, 110 }, { 6, 96 } }, true),
}

--------------------------------------------------------------------------------------------------------------- ground

-- Hills of one to four metres; the ponds lie flat in hollows, and the paths a little smoother than their ground.
map.create { path = height, width = 512, height = 512, type = "f32" }
map.noise(height, { scale = 46, octaves = 3, amount = 7, seed = 11, mode = "set" })
map.curve(height, { { 0, 0 }, { 2, 0.6 }, { 5, 4.2 }, { 7, 5 } })
map.blur(height, 2)
local function lowestAround(pond)
    local lowest = math.huge
    for x = -pond.hollow, pond.hollow do
        for z = -pond.hollow, pond.hollow do
            if x * x + z * z < pond.hollow ^ 2 then
                lowest = math.min(lowest, map.at(height, pond.centre[1] + x, pond.centre[2] + z))
            end
        end
    end
    return lowest
end
for _, pond in ipairs(ponds) do
    map.disc(height, { x = pond.centre[1], z = pond.centre[2], radius = pond.hollow, soft = 2 * pond.hollow - 2, mode = "add", value = -pond.deep })
    local level = lowestAround(pond) - 0.2
    map.polygon(height, { points = pond.shore, value = level + 0.3, soft = 18, opacity = 0.9 })
    map.polygon(height, { points = pond.shore, value = level - 0.9, soft = 5 })
    pond.level = math.floor(100 * level + 10) / 100
end
map.blur(height, 0.8)
map.noise(height, { scale = 3, octaves = 3, amount = 0.04, seed = 12 })

-- Water stands in each pond at its own level, no farther than its shore.
for i, pond in ipairs(ponds) do
    local radius = 0
    for _, p in ipairs(pond.shore) do
        radius = math.max(radius, math.sqrt((p[1] - pond.centre[1]) ^ 2 + (p[2] - pond.centre[2]) ^ 2))
    end
    entity.add("pond-" .. i, { Transform = { position = { pond.centre[1], pond.level, pond.centre[2] } },
                               Water = { level = pond.level, radius = math.ceil(radius) + 2, clarity = 1.6 } })
end

-- Colours (sRGB) over the soil: gravel, and the mud of the ponds' banks and beds.
map.create { path = ground, width = 1200, height = 1200, type = "u8", value = { 0.3, 0.26, 0.19, 0 } }
for _, path in ipairs(paths) do
    map.polyline(ground, { points = path.points, width = path.width, soft = 0.35, value = { 0.46, 0.42, 0.35, 1 } })
end
for _, pond in ipairs(ponds) do
    map.polygon(ground, { points = pond.shore, soft = 2.5, value = { 0.27, 0.23, 0.17, 1 } })
    map.polygon(ground, { points = pond.shore, soft = 7, value = { 0.12, 0.135, 0.14, 1 } })
end
map.noise(ground, { scale = 0.4, octaves = 2, amount = 0.3, seed = 21, mode = "multiply", channels = { 1, 2, 3 } })

---------------------------------------------------------------------------------------------------------------- grass

map.create { path = lawn, width = 1200, height = 1200, type = "u16", value = 1 }
map.create { path = meadow, width = 1200, height = 1200, type = "u16", value = 0 }

-- Meadows with soft, ragged edges, thinner here and there. Where they stand the lawn gives way.
for _, outline in ipairs(meadows) do
    map.polygon(meadow, { points = outline, soft = 16 })
    map.polygon(lawn, { points = outline, soft = 14, value = 0.45 })
end
map.noise(meadow, { scale = 7, octaves = 5, amount = 0.45, seed = 31 })
map.curve(meadow, { { 0.5, 0 }, { 0.8, 0.75 }, { 1, 1 } })
map.noise(meadow, { scale = 1.2, octaves = 3, amount = 0.6, seed = 33, mode = "multiply" })
map.noise(lawn, { scale = 7, octaves = 5, amount = 0.4, seed = 32, mode = "multiply" })
map.curve(lawn, { { 0, 0 }, { 0.3, 0.12 }, { 0.75, 0.85 }, { 1, 1 } })

-- Painted by hand: a trodden short cut, worn places by the path, and tufts along the ponds.
brush.select { map = lawn, mode = "subtract", radius = 1.1, strength = 0.09, falloff = 1 }
brush.stroke(curve { { 57, 48 }, { 50, 56 }, { 44, 66 } })
brush.stroke(curve { { 78, 64 }, { 74, 56 }, { 62, 52 }, { 57, 44 } })
brush.select { map = lawn, mode = "noise", radius = 4, strength = 0.3, falloff = 1, seed = 4 }
brush.stroke { { 62, 68 }, { 66, 72 } }
brush.select { map = meadow, mode = "add", radius = 1.6, strength = 0.1, falloff = 1 }
brush.stroke(curve { { 26, 40 }, { 33, 32.5 }, { 44, 33.5 }, { 51.5, 40 } })
brush.stroke(curve { { 75.5, 80 }, { 82, 73.5 }, { 91, 76 }, { 93.5, 84 } })
brush.select { map = meadow, mode = "smooth", radius = 4, strength = 0.5, falloff = 1 }
brush.stroke { { 70, 30 }, { 74, 40 } }

-- Nothing grows on the paths nor in the ponds; the edges are ragged where the noise of the density meets them.
for _, density in ipairs { lawn, meadow } do
    for _, path in ipairs(paths) do
        map.polyline(density, { points = path.points, width = path.width + 0.1, soft = 0.5, value = 0 })
    end
    for _, pond in ipairs(ponds) do
        map.polygon(density, { points = pond.shore, soft = 1.6, value = 0 })
    end
end

-- Which way the grass leans: a slow field, as wind and rain leave it.
map.create { path = orientation, width = 240, height = 240, type = "u16", value = 0.5 }
map.noise(orientation, { scale = 14, octaves = 2, amount = 0.9, seed = 41, channels = { 1 } })
map.noise(orientation, { scale = 14, octaves = 2, amount = 0.9, seed = 42, channels = { 2 } })

-- Drier, yellower grass on patches.
map.create { path = tint, width = 600, height = 600, type = "u8", value = { 0.55, 0.5, 0.24, 0 } }
map.noise(tint, { scale = 18, octaves = 4, amount = 0.8, seed = 51, mode = "set", channels = { 4 } })
map.curve(tint, { { 0.4, 0 }, { 0.8, 0.4 } }, { channels = { 4 } })

-------------------------------------------------------------------------------------------------------------- objects

local wood, dark, stone, iron = { 0.105, 0.062, 0.034 }, { 0.07, 0.042, 0.024 }, { 0.125, 0.12, 0.108 }, { 0.02, 0.024, 0.023 }
local shingle, plaster, leaf, bark = { 0.085, 0.038, 0.027 }, { 0.26, 0.24, 0.2 }, { 0.03, 0.058, 0.013 }, { 0.055, 0.043, 0.033 }

-- Shapes are listed and written at once; their numbers are metres.
local function object(name, shapes) mesh.write("models/" .. name .. ".glb", shapes) end
local function box(x, y, z, w, h, d, color, turn) return { shape = "box", at = { x, y, z }, size = { w, h, d }, color = color, turn = turn } end
local function post(x, y, z, radius, height, color, top, sides)
    return { shape = "cylinder", at = { x, y, z }, radius = radius, top = top or radius, height = height, color = color, sides = sides or 12 }
end

-- A bench, 1.7 m wide, seen from its front at +z: iron legs that reach into the ground, wooden slats.
do
    local shapes = {}
    for _, x in ipairs { -0.7, 0.7 } do
        shapes[#shapes + 1] = box(x, -0.15, 0.2, 0.06, 0.58, 0.06, iron)
        shapes[#shapes + 1] = box(x, -0.15, -0.2, 0.06, 0.6, 0.06, iron)
        shapes[#shapes + 1] = box(x, 0.41, -0.26, 0.06, 0.48, 0.05, iron, { -14, 0, 0 })
        shapes[#shapes + 1] = box(x, 0.39, 0, 0.06, 0.04, 0.5, iron)
        shapes[#shapes + 1] = box(x, 0.62, 0.0, 0.05, 0.035, 0.5, iron)
        shapes[#shapes + 1] = box(x, 0.42, 0.22, 0.04, 0.21, 0.04, iron)
    end
    for i = 0, 4 do shapes[#shapes + 1] = box(0, 0.43, 0.2 - 0.1 * i, 1.7, 0.035, 0.08, wood) end
    for i = 0, 2 do shapes[#shapes + 1] = box(0, 0.53 + 0.12 * i, -0.265 - 0.03 * i, 1.7, 0.085, 0.03, wood, { -14, 0, 0 }) end
    object("bench", shapes)
end

-- A lamp of 3.6 m: plinth, post with rings, lantern under a hat.
object("lamp", {
    post(0, -0.2, 0, 0.17, 0.4, iron, 0.13), post(0, 0.2, 0, 0.07, 0.5, iron, 0.05), post(0, 0.7, 0, 0.07, 0.05, iron),
    post(0, 0.75, 0, 0.045, 2.2, iron, 0.035), post(0, 2.9, 0, 0.065, 0.05, iron), post(0, 2.98, 0, 0.09, 0.05, iron, 0.13, 8),
    post(0, 3.03, 0, 0.12, 0.34, { 0.75, 0.7, 0.55 }, 0.16, 8), post(0, 3.37, 0, 0.23, 0.2, iron, 0.04, 8), post(0, 3.57, 0, 0.03, 0.07, iron),
})

-- Three boulders, from one to four hundred kilograms.
for i, size in ipairs { { 0.75, 0.5, 0.6 }, { 0.45, 0.3, 0.5 }, { 0.3, 0.22, 0.26 } } do
    object("stone" .. i, { { shape = "ball", at = { 0, size[2] * 0.45, 0 }, size = size, rough = 0.16, seed = 40 + i, color = stone } })
end

-- A pavilion of eight sides, 5 m wide: stone floor, posts with braces, a rail, a roof in two steps with a lantern on it.
do
    local shapes = { post(0, -0.6, 0, 2.75, 0.72, stone, 2.7, 8), post(0, 0.12, 0, 2.55, 0.08, plaster, 2.55, 8),
                     post(0, 2.62, 0, 3.05, 1.25, shingle, 0.75, 8), post(0, 3.87, 0, 0.6, 0.4, plaster, 0.6, 8),
                     post(0, 4.22, 0, 0.95, 0.75, shingle, 0.02, 8), post(0, 2.52, 0, 2.45, 0.1, dark, 2.45, 8), post(0, 4.9, 0, 0.05, 0.35, iron, 0.02) }
    for i = 0, 7 do
        local a, r = (i / 8) * 2 * math.pi, 2.3
        local x, z = r * math.cos(a), r * math.sin(a)
        shapes[#shapes + 1] = post(x, 0.15, z, 0.09, 2.4, plaster, 0.08)
        shapes[#shapes + 1] = post(x, 0.15, z, 0.14, 0.16, plaster, 0.12)
        shapes[#shapes + 1] = post(x, 2.38, z, 0.09, 0.14, plaster, 0.15)
        if i ~= 2 then  -- the side that is open to the path
            local b, side = a + math.pi / 8, 2 * r * math.sin(math.pi / 8)
            local mx, mz, heading = r * math.cos(math.pi / 8) * math.cos(b), r * math.cos(math.pi / 8) * math.sin(b), 90 - math.deg(b)
            shapes[#shapes + 1] = box(mx, 0.95, mz, side, 0.07, 0.09, dark, { 0, heading, 0 })
            shapes[#shapes + 1] = box(mx, 0.32, mz, side, 0.06, 0.06, dark, { 0, heading, 0 })
            for k = -3, 3 do
                local t = k / 7 * side
                shapes[#shapes + 1] = box(mx - t * math.sin(b), 0.34, mz + t * math.cos(b), 0.04, 0.62, 0.04, dark, { 0, heading, 0 })
            end
        end
    end
    object("pavilion", shapes)
end

-- Trees: a trunk with roots, some boughs, and a crown of several balls of leaves.
local function tree(name, height, crown, seed)
    local shapes = { post(0, -0.4, 0, height * 0.045, height * 0.1 + 0.4, bark, height * 0.03), post(0, height * 0.1, 0, height * 0.03, height * 0.5, bark, height * 0.016) }
    for i = 0, 4 do
        shapes[#shapes + 1] = { shape = "cylinder", at = { 0, height * 0.36 + i * height * 0.045, 0 }, radius = height * 0.011, top = height * 0.004, height = height * 0.3,
                                color = bark, sides = 9, turn = { 48 - i * 3, i * 137 + seed * 31, 0 } }
    end
    shapes[#shapes + 1] = { shape = "leaves", at = { 0, height * 0.72, 0 }, size = { crown * 0.78, height * 0.24, crown * 0.78 }, count = 2400, leaf = 0.27, seed = seed, color = leaf }
    for i = 0, 6 do
        local a, r = i * 2.4 + seed, crown * (0.55 + 0.25 * (i * 3 % 5) / 5)
        shapes[#shapes + 1] = { shape = "leaves", at = { r * math.cos(a), height * (0.57 + 0.075 * (i % 4)), r * math.sin(a) }, size = { crown * 0.48, height * 0.13, crown * 0.48 },
                                count = 950, leaf = 0.27, seed = seed * 10 + i, color = leaf }
    end
    object(name, shapes)
end
tree("tree1", 8.5, 2.6, 1)
tree("tree2", 6.5, 2.1, 2)
tree("tree3", 10.5, 3.0, 3)

local count = 0
local function put(model, x, z, heading, scale)
    count = count + 1
    entity.add(string.format("%s-%02d", model, count), {
        Transform = { position = { x, 0, z } },
        StaticMesh = { file = "models/" .. model .. ".glb", rotationDeg = { 0, heading or 0, 0 }, scale = scale or 1 },
    })
end

put("pavilion", 60, 57.5, 0)
put("bench", 41.2, 60.4, 0)
put("bench", 33.5, 61.9, 12)
put("bench", 71, 70.2, 160)
put("bench", 58.5, 41.5, 265)
for _, at in ipairs { { 12, 66 }, { 31, 68.4 }, { 49.5, 65 }, { 64, 71 }, { 80, 61.6 }, { 99, 58.7 }, { 55, 40 }, { 63.5, 86 } } do put("lamp", at[1], at[2]) end
put("stone1", 51.5, 45.5, 30)
put("stone2", 52.7, 44.6, 100)
put("stone3", 50.9, 44.4, 200)
put("stone1", 27.5, 35.5, 120, 1.3)
put("stone3", 28.6, 34.2, 10)
put("stone2", 94.5, 86.5, 70)
put("stone1", 102.5, 33.5, 250, 0.9)
for i, at in ipairs { { 22, 30 }, { 16, 36 }, { 25, 22 }, { 46, 24 }, { 84, 98 }, { 90, 104 }, { 79, 107 }, { 101, 96 }, { 108, 72 }, { 102, 78 }, { 12, 52 }, { 73, 52 }, { 69, 12 }, { 52, 84 } } do
    put("tree" .. (i * 7 % 3 + 1), at[1], at[2], i * 77 % 360, 0.85 + 0.3 * (i * 5 % 7) / 7)
end

-- No grass under the pavilion's floor, and trodden before its steps.
for _, density in ipairs { lawn, meadow } do
    map.disc(density, { x = 60, z = 57.5, radius = 2.9, soft = 0.4, value = 0 })
    map.disc(density, { x = 60, z = 61, radius = 1.4, soft = 1, value = 0.3, mode = "multiply" })
end
-------------------------------------------------------------------------------------------------------------- cameras

local function above(x, z, metres) return { x, map.at(height, x, z) + metres, z } end
entity.add("whole", { Camera = { eye = { 60, 56, -78 }, target = { 60, 0, 44 }, fovDeg = 55 } })
entity.add("human", { Camera = { eye = above(46.5, 67.5, 1.7), target = above(41, 53, 0.3), fovDeg = 55 } })
-- A lantern that someone swings around over the lawn.
entity.add("lantern", { Transform = { position = above(44.4, 64.2, 0.5) },
                        Light = { type = "point", color = { 1, 0.7, 0.38 }, intensity = 10, attenuation = 3,
                                  orbitRadius = 0.8, orbitSeconds = 6 } })
entity.add("low", { Camera = { eye = above(111, 40, 0.28), target = above(100, 30, 0.45), fovDeg = 55 } })

project.saveAs(".")

-- What objects and hills leave of the sky: rays need the objects where the project lies.
bake.ambientOcclusion { samples = 64, size = 512 }
project.save()
