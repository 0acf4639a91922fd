-- A park of 120 x 120 m: rolling ground, gravel paths, two ponds left bare, a mown lawn with soft edges, and meadows of
-- tall grass. Writes project.json and maps/ beside itself.

local size = 120
local lawn, meadow = "grass.GrassField.species[lawn].density", "grass.GrassField.species[meadow].density"
local height, ground = "ground.Terrain.height", "ground.Terrain.terrainMap"
local orientation, tint = "grass.GrassField.orientation", "grass.GrassField.vegetation"

---------------------------------------------------------------------------------------------------------------- scene

project.new()
for _, name in ipairs(entity.list()) do entity.remove(name) end

entity.add("ground", { Terrain = { size = { size, size }, groundColor = { 0.11, 0.085, 0.055 } } })
entity.add("grass", { GrassField = {
    cellSize = 1, minGeom = 3, maxGeom = 8,
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
entity.add("sun", { Light = { azimuthDeg = 105, elevationDeg = 38 } })
entity.add("sky", { Sky = { turbidity = 3.5 } })
entity.add("haze", { Fog = { visibility = 2500 } })

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
    map.polygon(height, { points = pond.shore, value = level, soft = 3 })
end
map.blur(height, 0.8)
map.noise(height, { scale = 3, octaves = 3, amount = 0.04, seed = 12 })

-- Colours (sRGB) over the soil: gravel, and the mud of the ponds darkening towards the middle.
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

-------------------------------------------------------------------------------------------------------------- cameras

local function above(x, z, metres) return { x, map.at(height, x, z) + metres, z } end
entity.add("whole", { Camera = { eye = { 60, 56, -78 }, target = { 60, 0, 44 }, fovDeg = 55 } })
entity.add("human", { Camera = { eye = above(46.5, 67.5, 1.7), target = above(41, 53, 0.3), fovDeg = 55 } })
entity.add("low", { Camera = { eye = above(111, 40, 0.28), target = above(100, 30, 0.45), fovDeg = 55 } })

project.saveAs(".")
