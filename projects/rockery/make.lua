-- A rockery: mossy and grassy rocks on gravel, a hut with a turf roof, and a ball in space; every blade stands on a mesh
-- (Habel, Wimmer and Jeschke 2007: slices under any surface with texture coordinates).
-- Writes project.json, maps/ and models/ beside itself.

local size = 10
local height = "ground.Terrain.height"

project.new()
for _, name in ipairs(entity.list()) do entity.remove(name) end

entity.add("ground", { Terrain = { beyond = "fade", size = { size, size }, groundColor = { 0.19, 0.18, 0.165 }, gridSpacing = 0.25, castShadows = true } })
-- Slices are sharper than by default: frames that add up smooth the grain. Blades of moss, 60,000 on a square metre, are
-- drawn one by one up to as far as those of the turf are, or a little less.
entity.add("moss", { GrassField = {
    onTerrain = false, minGeom = 3, maxGeom = 3.5, cellSize = 0.25, slices = 16, sharpness = 3, sliceWidth = 256, sliceHeight = 64, farSize = 256, seed = 3,
    species = { {
        name = "moss", bladesPerM2 = 60000, height = 0.022, heightVariation = 0.4, width = 0.0022, bend = 0.35, leanDeg = 16,
        leanVariationDeg = 16, segments = 3, clumpSize = 0.07, clumpStrength = 0.6, translucency = 0.5, gloss = 0.2,
        rootColor = { 0.03, 0.038, 0.012 }, midColor = { 0.06, 0.095, 0.02 }, tipColor = { 0.13, 0.17, 0.035 },
    } },
} })
entity.add("turf", { GrassField = {
    onTerrain = false, cellSize = 0.5, slices = 16, sharpness = 3, sliceWidth = 512, sliceHeight = 128, farSize = 512, seed = 8,
    species = { {
        name = "turf", bladesPerM2 = 9000, height = 0.11, heightVariation = 0.4, width = 0.004, bend = 0.6, leanDeg = 14,
        leanVariationDeg = 16, segments = 4, clumpSize = 0.22, clumpStrength = 0.5, translucency = 0.75, gloss = 0.45,
        rootColor = { 0.045, 0.06, 0.02 }, midColor = { 0.06, 0.12, 0.03 }, tipColor = { 0.11, 0.165, 0.045 },
    } },
} })
-- Frames that add up are as near to the truth as four samples, in less time (sward cost).
entity.add("antialias", { Antialias = { antialias = "temporal" } })
entity.add("sun", { Light = { azimuthDeg = 235, elevationDeg = 40 } })
entity.add("sky", { Sky = { model = "atmosphere", turbidity = 1.3 } })
entity.add("haze", { Fog = { visibility = 6000 } })
entity.add("wind", { Wind = { strength = 0.12, azimuthDeg = 60, speed = 3, gustSize = 4, turbulence = 0.4 } })

map.create { path = height, width = 128, height = 128, type = "f32" }
map.noise(height, { scale = 4, octaves = 3, amount = 0.35, seed = 11, mode = "set" })
map.blur(height, 1)
local function ground(x, z) return map.at(height, x, z) end

-- Where on a ball a texel lies: its texture coordinates are six squares, three in a row (docs/scripting.md, unwrap).
local axes = { { 1, 2, 3 }, { 2, 3, 1 }, { 3, 1, 2 } }  -- across, along v, along u
local function wayAt(u, v)
    local column, row = math.min(2, math.floor(u * 3)), math.min(1, math.floor(v * 3))
    local face = 3 * row + column
    local function inside(x, first) return math.max(0, math.min(1, ((x * 3 - first) - 0.02) / 0.96)) end
    local along, across = inside(u, column) * 2 - 1, inside(v, row) * 2 - 1
    local side = face % 2 == 1 and 1 or -1
    local order, way = axes[math.floor(face / 2) + 1], {}
    way[order[1]] = side
    way[order[2]] = side * math.tan(across * math.pi / 4)
    way[order[3]] = math.tan(along * math.pi / 4)
    local length = math.sqrt(way[1] ^ 2 + way[2] ^ 2 + way[3] ^ 2)
    return way[1] / length, way[2] / length, way[3] / length
end
-- Smooth, without a seam, in about [-1, 1].
local function patches(x, y, z, scale, seed)
    return (math.sin(scale * (1.3 * x + 0.7 * z) + seed) * math.cos(scale * (1.1 * y - 0.6 * x) + 1.7 * seed)
        + 0.6 * math.sin(scale * (2.1 * z - 1.4 * y) + 0.4 * seed) * math.cos(scale * 1.9 * x + seed)) / 1.4
end
local function ramp(x, low, high)
    local t = math.max(0, math.min(1, (x - low) / (high - low)))
    return t * t * (3 - 2 * t)
end

-- Grass on a rock from where its surface looks up steeply enough, in patches; less on the side of the sun.
local function growOn(name, field, low, seed)
    entity.set(name .. ".MeshGrass.field", field)
    local density = name .. ".MeshGrass.density"
    map.create { path = density, width = 192, height = 192, type = "u8", value = 1 }
    map.fill(density, function(u, v)
        local x, y, z = wayAt(u, v)
        return ramp(y + 0.35 * patches(x, y, z, 5, seed) - 0.12 * z, low, low + 0.3)
    end)
end
-- Yellow and brown here and there, over the same ball.
local function tint(name, strength, seed)
    local paint = name .. ".MeshGrass.vegetation"
    map.create { path = paint, width = 96, height = 96, type = "u8", value = { 0.5, 0.45, 0.2, 0 } }
    map.fill(paint, function(u, v)
        local x, y, z = wayAt(u, v)
        return 0.52, 0.44, 0.2, strength * ramp(patches(x, y, z, 7, seed), 0, 0.8)
    end)
end

local stone = { { 0.15, 0.145, 0.135 }, { 0.17, 0.155, 0.13 }, { 0.13, 0.13, 0.125 } }
local rocks = {
    -- x, z, half axes, turn, field, least height of the surface's normal
    { 3.1, 3.9, { 0.75, 0.55, 0.6 }, 20, "turf", 0.3 },
    { 4.3, 3.3, { 0.4, 0.3, 0.45 }, 75, "moss", -0.1 },
    { 2.1, 3.2, { 0.45, 0.32, 0.38 }, 130, "moss", 0.05 },
    { 3.9, 4.9, { 0.9, 0.7, 0.65 }, 210, "moss", 0.1 },
    { 5.2, 4.3, { 0.5, 0.42, 0.5 }, 300, "turf", 0.35 },
    { 4.9, 2.5, { 0.28, 0.2, 0.24 }, 15, "moss", -0.4 },
    { 1.7, 4.7, { 0.6, 0.5, 0.55 }, 95, "turf", 0.2 },
    { 6.3, 3.2, { 0.55, 0.36, 0.42 }, 250, "moss", 0.2 },
}
for i, rock in ipairs(rocks) do
    local x, z, half, turn, field, low = table.unpack(rock)
    local file, name = "models/rock" .. i .. ".glb", "rock" .. i
    mesh.write(file, { { shape = "ball", at = { 0, half[2] * 0.45, 0 }, size = half, rough = 0.16, seed = 50 + i, color = stone[i % 3 + 1], unwrap = true } })
    entity.add(name, { Transform = { position = { x, 0, z } }, StaticMesh = { file = file, rotationDeg = { 0, turn, 0 } }, MeshGrass = {} })
    growOn(name, field, low, i)
    tint(name, field == "moss" and 0.55 or 0.35, 3 * i)
end

-- Pebbles around them.
for i = 1, 3 do
    mesh.write("models/pebble" .. i .. ".glb", { { shape = "ball", at = { 0, 0.03, 0 }, size = { 0.09, 0.06, 0.075 }, rough = 0.2, seed = 80 + i, color = stone[i] } })
end
for i = 1, 26 do
    local angle, far = i * 2.39996, 1.1 + 0.42 * math.sqrt(i)
    entity.add("pebble" .. i, { Transform = { position = { 4 + far * math.cos(angle), 0, 3.9 + far * math.sin(angle) } }, StaticMesh = { file = "models/pebble" .. (i % 3 + 1) .. ".glb", rotationDeg = { 0, 53 * i % 360, 0 }, scale = 0.6 + 0.07 * (i % 11) } })
end

-- A hut: turf on the upper faces of two slabs.
local wood, dark = { 0.16, 0.1, 0.055 }, { 0.1, 0.06, 0.035 }
mesh.write("models/hut.glb", {
    { shape = "box", at = { 0, 0, 0 }, size = { 2.2, 1.25, 1.6 }, color = wood },
    { shape = "box", at = { 0, 1.2, 0.28 }, size = { 2.2, 0.25, 0.9 }, turn = { 0, 0, 0 }, color = wood },
    { shape = "box", at = { -0.4, 0, -0.81 }, size = { 0.55, 1, 0.05 }, color = dark },
    { shape = "box", at = { 0.55, 0.55, -0.81 }, size = { 0.5, 0.4, 0.05 }, color = { 0.03, 0.035, 0.04 } },
})
mesh.write("models/roof.glb", {
    { shape = "box", at = { 0, 1.42, -0.52 }, size = { 2.7, 0.1, 1.3 }, turn = { -30, 0, 0 }, color = dark, unwrap = true },
    { shape = "box", at = { 0, 1.42, 0.52 }, size = { 2.7, 0.1, 1.3 }, turn = { 30, 0, 0 }, color = dark, unwrap = true },
})
entity.add("hut", { Transform = { position = { 5.2, 0, 7.2 } }, StaticMesh = { file = "models/hut.glb", rotationDeg = { 0, 18, 0 } } })
entity.add("roof", { Transform = { position = { 5.2, 0, 7.2 } }, StaticMesh = { file = "models/roof.glb", rotationDeg = { 0, 18, 0 } }, MeshGrass = { field = "turf" } })
map.create { path = "roof.MeshGrass.density", width = 96, height = 96, type = "u8", value = 1 }
map.fill("roof.MeshGrass.density", function(u, v)  -- the face that looks up is the first of the second row
    return (u < 1 / 3 and v > 1 / 3 and v < 2 / 3) and 0.75 + 0.25 * patches(u * 6, v * 6, u * 3, 3, 2) or 0
end)

-- A ball in space.
mesh.write("models/ball.glb", { { shape = "ball", size = { 0.42, 0.42, 0.42 }, color = stone[2], unwrap = true } })
entity.add("ball", { Transform = { position = { 6.3, ground(6.3, 4.7) + 1.55, 4.7 } }, StaticMesh = { file = "models/ball.glb", onGround = false }, MeshGrass = { field = "turf" } })

local function above(x, z, metres) return { x, ground(x, z) + metres, z } end
entity.add("whole", { Camera = { eye = { 4.2, 3.4, -2.6 }, target = above(4.4, 4.4, 0.3), fovDeg = 55 } })
entity.add("human", { Camera = { eye = above(3.4, 0.6, 1.7), target = above(4.3, 4.4, 0.5), fovDeg = 55 } })
entity.add("low", { Camera = { eye = above(3.3, 2.15, 0.55), target = above(3.6, 4, 0.45), fovDeg = 50 } })
project.saveAs(".")
