-- A storm's path through tall grass: painted forces that swirl around its foot (Jahrmann and Wimmer 2013, figure 13), and waves of
-- wind after equation 9. Writes project.json and maps/ beside itself.

local size = 60
local forces = "grass.GrassField.forces"
local foot = { 30, 26 }

project.new()
for _, name in ipairs(entity.list()) do entity.remove(name) end

entity.add("ground", { Terrain = { size = { size, size }, groundColor = { 0.11, 0.085, 0.055 } } })
entity.add("grass", { GrassField = {
    technique = "tessellated", cellSize = 1, minGeom = 6, maxGeom = 14, minBTF = 30, maxBTF = 45, slices = 16, sliceWidth = 512, farSize = 512,
    species = {
        { name = "tall", bladesPerM2 = 1600, height = 0.5, heightVariation = 0.25, width = 0.008, bend = 0.5, leanDeg = 10,
          leanVariationDeg = 12, segments = 4, clumpSize = 0.5, clumpStrength = 0.5, translucency = 0.7, gloss = 0.4,
          rootColor = { 0.05, 0.06, 0.02 }, midColor = { 0.075, 0.125, 0.035 }, tipColor = { 0.14, 0.165, 0.055 } },
    },
}, TessellatedBlades = { levelBy = "pixels", maxDistance = 45, leastPixels = 0.5, thinning = 0 } })
entity.add("antialias", { Antialias = { antialias = "temporal" } })
entity.add("sun", { Light = { azimuthDeg = 150, elevationDeg = 34, intensity = 0.8 } })
entity.add("sky", { Sky = { turbidity = 6 } })
entity.add("haze", { Fog = { visibility = 700 } })
entity.add("wind", { Wind = { model = "waves", strength = 0.25, azimuthDeg = 110, speed = 6, c1 = 0.2, c2 = 0.06, c3 = 0.1, epsilon = 0.4 } })
entity.add("human", { Camera = { eye = { 30, 6, 43 }, target = { 30, 0, 26 }, fovDeg = 60 } })
entity.add("low", { Camera = { eye = { 24, 1.6, 35 }, target = { 30, 0.3, 26 }, fovDeg = 55 } })

-- Blades lie along circles around the foot, drawn inwards; less with the distance, none in the eye. In two arms that wind
-- inwards they are pressed flat, with their upper sides to the sky.
map.create { path = forces, width = 512, height = 512, type = "u8", value = { 0.5, 0.5, 0, 0 } }
map.fill(forces, function(x, z)
    local dx, dz = x - foot[1], z - foot[2]
    local r = math.sqrt(dx * dx + dz * dz)
    if r < 0.4 or r > 15 then return 0.5, 0.5, 0, 0 end
    local turn = math.atan(dz, dx) + 0.6 * math.sin(r * 0.9)
    local ox, oz = -math.sin(turn) - 0.45 * math.cos(turn), math.cos(turn) - 0.45 * math.sin(turn)
    local length = math.sqrt(ox * ox + oz * oz)
    local share = math.min(1, (r - 0.4) / 0.8) * (1 - r / 15) ^ 0.8
    local arm = 0.5 + 0.5 * math.sin(2 * math.atan(dz, dx) - 9 * math.log(1 + 0.25 * r))
    local press = (1 - r / 15) ^ 0.5 * (0.05 + 0.93 * arm ^ 1.5 * math.min(1, r / 1.5))
    return 0.5 + 0.5 * ox / length, 0.5 + 0.5 * oz / length, press, share
end)
project.saveAs(".")
