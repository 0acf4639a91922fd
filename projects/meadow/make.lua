-- A meadow with boulders, over which a giant has walked (Jahrmann and Wimmer 2013, figures 6 and 10). Tessellated blades, wind in gusts.
-- Writes project.json, maps/ and models/ beside itself.

local size = 120
local height, tall, tint = "ground.Terrain.height", "grass.GrassField.species[tall].density", "grass.GrassField.vegetation"

project.new()
for _, name in ipairs(entity.list()) do entity.remove(name) end

entity.add("ground", { Terrain = { beyond = "fade", size = { size, size }, groundColor = { 0.11, 0.085, 0.055 } } })
entity.add("grass", { GrassField = {
    technique = "tessellated", cellSize = 1, slices = 16, sliceWidth = 512, farSize = 512,
    species = {
        { name = "tall", bladesPerM2 = 1500, height = 0.45, heightVariation = 0.3, width = 0.007, bend = 0.55, leanDeg = 10, smoothness = 5,
          leanVariationDeg = 14, segments = 4, clumpSize = 0.45, clumpStrength = 0.6, translucency = 0.8, gloss = 0.4,
          rootColor = { 0.05, 0.06, 0.02 }, midColor = { 0.08, 0.125, 0.035 }, tipColor = { 0.16, 0.17, 0.06 } },
        { name = "low", bladesPerM2 = 2500, height = 0.14, heightVariation = 0.3, width = 0.005, bend = 0.5, leanDeg = 12, smoothness = 3,
          leanVariationDeg = 14, segments = 3, clumpSize = 0.3, clumpStrength = 0.5, translucency = 0.6 },
    },
}, TessellatedBlades = { maxDistance = 40, levelBy = "pixels", leastPixels = 0.5, thinning = 0 } })
entity.add("antialias", { Antialias = { antialias = "temporal" } })
entity.add("sun", { Light = { azimuthDeg = 215, elevationDeg = 36 } })
entity.add("sky", { Sky = { model = "atmosphere", turbidity = 1.5 } })
entity.add("haze", { Fog = { visibility = 5000 } })
entity.add("wind", { Wind = { strength = 0.22, azimuthDeg = 60, speed = 4, gustSize = 9, turbulence = 0.4 } })

map.create { path = height, width = 256, height = 256, type = "f32" }
map.noise(height, { scale = 45, octaves = 3, amount = 6, seed = 17, mode = "set" })
map.blur(height, 3)

map.create { path = tall, width = 960, height = 960, type = "u16", value = 1 }
map.noise(tall, { scale = 9, octaves = 4, amount = 0.9, seed = 23, mode = "multiply" })
map.curve(tall, { { 0, 0 }, { 0.25, 0.1 }, { 0.7, 0.9 }, { 1, 1 } })

map.create { path = tint, width = 480, height = 480, type = "u8", value = { 0.58, 0.53, 0.26, 0 } }
map.noise(tint, { scale = 16, octaves = 4, amount = 0.7, seed = 5, mode = "set", channels = { 4 } })
map.curve(tint, { { 0.4, 0 }, { 0.7, 0.35 } }, { channels = { 4 } })

-- Boulders, and bare ground under each; each pushes the grass aside around its outline.
local stone = { 0.13, 0.125, 0.11 }
for i, s in ipairs { { 1.5, 1.0, 1.2 }, { 0.8, 0.6, 0.9 }, { 2.4, 1.7, 2.0 } } do
    mesh.write("models/boulder" .. i .. ".glb", { { shape = "ball", at = { 0, s[2] * 0.4, 0 }, size = s, rough = 0.2, seed = 70 + i, color = stone } })
end
for i, at in ipairs { { 52, 74, 1 }, { 54.4, 72.8, 2 }, { 68, 62, 3 }, { 71, 64.5, 2 }, { 40, 60, 1 }, { 84, 80, 3 }, { 34, 44, 2 }, { 62, 88, 2 } } do
    entity.add("boulder" .. i, { Transform = { position = { at[1], 0, at[2] } },
                                 StaticMesh = { file = "models/boulder" .. at[3] .. ".glb", rotationDeg = { 0, 67 * i % 360, 0 } },
                                 ForceSource = { shape = "outline", radius = 0.3, reach = 2.5 } })
    map.disc(tall, { x = at[1], z = at[2], radius = ({ 0.9, 0.55, 1.4 })[at[3]], soft = 0.4, value = 0 })
end

-- The giant's feet: 5 m long and 2 m wide, one after the other. Pressed flat inside, pushed away around.
local forces = "grass.GrassField.forces"
local prints, heading, half, radius, reach = {}, math.rad(28), 1.5, 1.0, 1.7
local ax, az = math.sin(heading), -math.cos(heading)
for i = 0, 6 do
    local along, side = 7.5 * i - 4, (i % 2 * 2 - 1) * 1.7
    prints[#prints + 1] = { 46 + ax * along - az * side, 92 + az * along + ax * side }
end
-- What lies crushed is bruised and dry: a giant's steps are seen from any side, whatever the sun.
for _, p in ipairs(prints) do
    map.polyline(tint, { points = { { p[1] - half * ax, p[2] - half * az }, { p[1] + half * ax, p[2] + half * az } }, width = 2 * radius, soft = 0.4, value = { 0.36, 0.36, 0.18, 0.55 } })
end
map.create { path = forces, width = 768, height = 768, type = "u8", value = { 0.5, 0.5, 0, 0 } }
map.fill(forces, function(x, z)
    for _, p in ipairs(prints) do
        local dx, dz = x - p[1], z - p[2]
        if math.abs(dx) < 4 and math.abs(dz) < 4 then
            local t = math.max(-half, math.min(half, dx * ax + dz * az))
            local ox, oz = dx - t * ax, dz - t * az
            local r = math.sqrt(ox * ox + oz * oz)
            if r < radius * reach then
                local push = r < radius and math.min(1, 2 * r / radius) or (radius * reach - r) / (radius * (reach - 1))
                local press = math.max(0, math.min(1, (radius - r) / (0.2 * radius)))
                local share = math.max(push, press)
                return 0.5 + 0.5 * push / share * ox / math.max(r, 0.01), 0.5 + 0.5 * push / share * oz / math.max(r, 0.01), press / share, share
            end
        end
    end
    return 0.5, 0.5, 0, 0
end)

local function above(x, z, metres) return { x, map.at(height, x, z) + metres, z } end
entity.add("human", { Camera = { eye = above(44, 101, 5.5), target = above(52, 84, 0), fovDeg = 58 } })
entity.add("low", { Camera = { eye = above(45, 80, 0.9), target = above(60, 68, 0.6), fovDeg = 55 } })
entity.add("whole", { Camera = { eye = above(40, 112, 14), target = above(62, 66, 0), fovDeg = 55 } })
project.saveAs(".")
