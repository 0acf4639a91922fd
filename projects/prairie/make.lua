-- A prairie of any size (Jahrmann and Wimmer 2013, section 6.2 and figure 11): rolling land, tall and short grass, flowers, wind.
-- Terrain.size alone makes it larger, from 300 to 90,000 m: maps are laid out over mapSize metres and repeat, each after another length, so
-- that no two of them repeat together within 100 km. Writes project.json and maps/ beside itself.

local size = 300
local height, ground = "land.Terrain.height", "land.Terrain.terrainMap"
local tall, short = "grass.GrassField.species[tall].density", "grass.GrassField.species[short].density"
local daisies = "daisies.Flowers.density"
local blades, tint = "grass.GrassField.bladeHeight", "grass.GrassField.vegetation"

project.new()
for _, name in ipairs(entity.list()) do entity.remove(name) end

-- Metres after which each map repeats; the tiling is how often that is in mapSize.
local mapSize = 256
local function every(metres) return mapSize / metres end
entity.add("land", { Terrain = { beyond = "fade", 
    size = { size, size }, mapSize = mapSize, heightTiling = every(760), terrainMapTiling = every(613),
    groundColor = { 0.11, 0.088, 0.052 }, gridSpacing = 1, lodDistance = 60,
} })
entity.add("grass", { GrassField = {
    technique = "tessellated", cellSize = 1, slices = 16, sliceWidth = 512, farSize = 512, minBTF = 30, maxBTF = 45,
    bladeHeightTiling = every(139), vegetationTiling = every(431),
    species = {
        { name = "tall", densityTiling = every(173), bladesPerM2 = 750, height = 0.75, heightVariation = 0.3, width = 0.009, bend = 0.42, leanDeg = 10,
          leanVariationDeg = 15, smoothness = 6, segments = 4, clumpSize = 0.6, clumpStrength = 0.6, translucency = 0.8, gloss = 0.35,
          rootColor = { 0.07, 0.07, 0.03 }, midColor = { 0.17, 0.145, 0.075 }, tipColor = { 0.37, 0.31, 0.19 }, hueVariationDeg = 5, lightnessVariation = 0.2 },
        { name = "short", densityTiling = every(97), bladesPerM2 = 1900, height = 0.22, heightVariation = 0.3, width = 0.006, bend = 0.42, leanDeg = 12,
          leanVariationDeg = 15, smoothness = 3, segments = 3, clumpSize = 0.35, clumpStrength = 0.5, translucency = 0.6, gloss = 0.2,
          rootColor = { 0.04, 0.052, 0.02 }, midColor = { 0.045, 0.085, 0.03 }, tipColor = { 0.075, 0.115, 0.045 } },
    },
}, TessellatedBlades = { maxDistance = 36, levelBy = "pixels", leastPixels = 0.5, thinning = 0 } })
entity.add("antialias", { Antialias = { antialias = "temporal" } })
entity.add("daisies", { Flowers = { densityTiling = every(67), flowersPerM2 = 9, height = 0.38, heightVariation = 0.35, headSize = 0.05, color = { 0.74, 0.6, 0.1 },
    secondColor = { 0.74, 0.7, 0.6 }, maxDistance = 80 } })
entity.add("sun", { Light = { azimuthDeg = 205, elevationDeg = 33 } })
entity.add("sky", { Sky = { model = "atmosphere", turbidity = 1.3 } })
entity.add("haze", { Fog = { visibility = 4000 } })
entity.add("wind", { Wind = { strength = 0.25, azimuthDeg = 100, speed = 5, gustSize = 11, turbulence = 0.4 } })

-- Heights are mirrored where they repeat: waves with a crest or a trough on every edge go on there without a crease.
local waves, seed = {}, 7
local function random()
    seed = (seed * 16807) % 2147483647
    return seed / 2147483647
end
for _ = 1, 26 do
    local m, n = math.floor(random() * 13), math.floor(random() * 13)
    waves[#waves + 1] = { m, n, (random() - 0.5) * 62 / (1.6 + math.sqrt(m * m + n * n)) }
end
map.create { path = height, width = 256, height = 256, type = "f32" }
local length = 760
map.fill(height, function(x, z)
    local sum = 0
    for _, w in ipairs(waves) do sum = sum + w[3] * math.cos(math.pi * w[1] * x / length) * math.cos(math.pi * w[2] * z / length) end
    return sum
end)

-- Tall grass in drifts; short grass everywhere, thinner on dry ground.
map.create { path = tall, width = 1024, height = 1024, type = "u16", value = 0 }
map.noise(tall, { scale = 19, octaves = 5, amount = 1, seed = 23, mode = "set", seamless = true })
map.curve(tall, { { 0, 0 }, { 0.46, 0 }, { 0.6, 0.85 }, { 1, 1 } })
map.create { path = short, width = 512, height = 512, type = "u16", value = 0 }
map.noise(short, { scale = 7, octaves = 4, amount = 1, seed = 31, mode = "set", seamless = true })
map.curve(short, { { 0, 0.35 }, { 0.4, 0.75 }, { 0.55, 1 }, { 1, 1 } })

-- Flowers in drifts of their own.
map.create { path = daisies, width = 512, height = 512, type = "u8", value = 0 }
map.noise(daisies, { scale = 7, octaves = 4, amount = 1, seed = 41, mode = "set", seamless = true })
map.curve(daisies, { { 0.52, 0 }, { 0.72, 0.7 }, { 1, 1 } })

-- Blades are lower where the soil is poor.
map.create { path = blades, width = 512, height = 512, type = "u8", value = 0 }
map.noise(blades, { scale = 15, octaves = 4, amount = 1, seed = 3, mode = "set", seamless = true })
map.curve(blades, { { 0.3, 0.42 }, { 0.65, 1 } })

-- Straw over the green in wide drifts, and the same earth below.
map.create { path = tint, width = 512, height = 512, type = "u8", value = { 0.64, 0.57, 0.38, 0 } }
map.noise(tint, { scale = 60, octaves = 5, amount = 1, seed = 5, mode = "set", seamless = true, channels = { 4 } })
map.curve(tint, { { 0.4, 0 }, { 0.75, 0.4 } }, { channels = { 4 } })
map.create { path = ground, width = 512, height = 512, type = "u8", value = { 0.42, 0.36, 0.25, 0 } }
map.noise(ground, { scale = 80, octaves = 5, amount = 1, seed = 11, mode = "set", seamless = true, channels = { 4 } })
map.curve(ground, { { 0.35, 0 }, { 0.8, 0.7 } }, { channels = { 4 } })

local function above(x, z, metres) return { x, map.at(height, x, z) + metres, z } end
-- A person stands where the land falls away most towards the far corner.
local bestX, bestZ, fall = 60, 60, -math.huge
for x = 20, 130, 5 do
    for z = 20, 130, 5 do
        local here = map.at(height, x, z) - map.at(height, x + 60, z + 60)
        if here > fall then bestX, bestZ, fall = x, z, here end
    end
end
entity.add("human", { Camera = { eye = above(bestX, bestZ, 1.8), target = above(bestX + 45, bestZ + 45, 1), fovDeg = 58 } })
entity.add("low", { Camera = { eye = above(bestX + 8, bestZ + 8, 0.5), target = above(bestX + 30, bestZ + 34, 1), fovDeg = 55 } })
entity.add("whole", { Camera = { eye = above(-28, -40, 62), target = above(118, 130, -6), fovDeg = 58 } })
project.saveAs(".")
