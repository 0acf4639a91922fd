-- Pitch: turf mown in stripes with white lines, as large as fits, up to 105 by 68 m.
-- 120 m, 0 m of relief

local density, orientation, vegetation = "turf.GrassField.species[pitch].density", "turf.GrassField.orientation", "turf.GrassField.vegetation"
local height = "ground.Terrain.height"
local long, wide = math.min(105, size * 0.9), math.min(68, size * 0.9 * 68 / 105)
local x0, z0 = (size - long) / 2, (size - wide) / 2
local unit = long / 105  -- of a full-sized pitch's metres

entity.remove("lawn")
entity.set("ground.Terrain.size", { size, size })
entity.set("ground.Terrain.groundColor", { 0.09, 0.085, 0.045 })
entity.add("turf", { GrassField = { species = {
    { name = "pitch", bladesPerM2 = 45000, height = 0.032, heightVariation = 0.2, width = 0.0033, bend = 0.25, leanDeg = 24, leanVariationDeg = 9,
      segments = 2, smoothness = 3, clumpSize = 0.3, clumpStrength = 0.25, translucency = 0.5, gloss = 0.45,
      rootColor = { 0.04, 0.06, 0.018 }, midColor = { 0.05, 0.12, 0.028 }, tipColor = { 0.075, 0.15, 0.04 } },
} } })
entity.set("sun.Light.azimuthDeg", 312)
entity.set("sun.Light.elevationDeg", 40)
if relief > 0 then
    map.create { path = height, width = 256, height = 256, type = "f32" }
    map.noise(height, { scale = size / 2, octaves = 2, amount = relief, seed = 2, mode = "set" })
    map.blur(height, size / 20)
end

map.create { path = density, width = 1024, height = 1024, type = "u16", value = 1 }
map.noise(density, { scale = 6, octaves = 3, amount = 0.08, seed = 5, mode = "multiply" })

-- Twelve stripes, which the mower laid one way and the other.
map.create { path = orientation, width = 512, height = 512, type = "u8", value = { 0.5, 0.5 } }
for i = 0, 11 do
    local from = x0 + long * i / 12
    map.rect(orientation, { x0 = from, x1 = from + long / 12, z0 = z0 - 2, z1 = z0 + wide + 2, value = { 0.5, i % 2 == 0 and 1 or 0 } })
end

-- White lines, 12 cm wide: the same measures as on grounds everywhere.
map.create { path = vegetation, width = 4096, height = 4096, type = "u8", value = { 0.2, 0.35, 0.12, 0 } }
local white = { 0.93, 0.94, 0.9, 1 }
local line = math.max(0.12, size / 1500)
local function frame(ax, az, bx, bz)
    map.polyline(vegetation, { points = { { ax, az }, { bx, az }, { bx, bz }, { ax, bz } }, closed = true, width = line, value = white })
end
frame(x0, z0, x0 + long, z0 + wide)
local mx, mz = x0 + long / 2, z0 + wide / 2
map.line(vegetation, { x0 = mx, z0 = z0, x1 = mx, z1 = z0 + wide, width = line, value = white })
map.disc(vegetation, { x = mx, z = mz, radius = 9.15 * unit + line / 2, inner = 9.15 * unit - line / 2, value = white })
map.disc(vegetation, { x = mx, z = mz, radius = 0.2, value = white })
for side = 0, 1 do
    local goal, into = x0 + long * side, side == 0 and 1 or -1
    frame(goal, mz - 20.16 * unit, goal + into * 16.5 * unit, mz + 20.16 * unit)
    frame(goal, mz - 9.16 * unit, goal + into * 5.5 * unit, mz + 9.16 * unit)
    map.disc(vegetation, { x = goal + into * 11 * unit, z = mz, radius = 0.2, value = white })
end

local function above(x, z, metres) return { x, (relief > 0 and map.at(height, x, z) or 0) + metres, z } end
entity.set("camera.Camera.eye", above(x0 + long * 0.16, z0 + wide * 1.1, 0.085 * long))
entity.set("camera.Camera.target", above(mx, mz - wide * 0.05, 0))
