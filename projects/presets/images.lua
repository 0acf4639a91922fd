-- Images of the species presets (editor/model/species_presets.cpp), from root to tip, white where the species' colours
-- are to show: an ear of wheat, a spike of heather. Run by hand after a change: sward script projects/presets/images.lua

project.new()
local size = 40
entity.set("ground.Terrain.size", { size, size })
local picture = "lawn.GrassField.vegetation"

local function begin(side)
    if map.exists(picture) then entity.set(picture, nil) end
    map.create { path = picture, width = side, height = 8 * side, type = "u8", value = { 0.74, 0.74, 0.74, 0 } }
end
local function shape(points, value)  -- points: across -1 to 1, along 0 to 1
    local out = {}
    for i, p in ipairs(points) do out[i] = { (p[1] * 0.5 + 0.5) * size, p[2] * size } end
    map.polygon(picture, { points = out, value = value })
end

-- A thin stem, an ear of grains in two rows, beards that stand out.
begin(64)
shape({ { -0.16, 0 }, { 0.16, 0 }, { 0.1, 0.8 }, { -0.1, 0.8 } }, { 0.66, 0.66, 0.62, 1 })
for i = 0, 8 do
    local from, side = 0.74 + 0.022 * i, i % 2 * 2 - 1
    local wide = 0.75 - 0.05 * math.abs(i - 3)
    shape({ { 0, from }, { side * wide, from + 0.02 }, { side * wide * 0.9, from + 0.045 }, { 0, from + 0.06 } }, { 0.8 - 0.03 * (i % 2), 0.78, 0.74, 1 })
    shape({ { 0, from }, { -side * wide * 0.8, from + 0.03 }, { -side * wide * 0.6, from + 0.05 }, { 0, from + 0.06 } }, { 0.68, 0.66, 0.62, 1 })
    shape({ { side * wide * 0.8, from + 0.03 }, { side * wide * 0.95, from + 0.04 }, { side * 0.85, from + 0.12 } }, { 0.86, 0.84, 0.78, 1 })
end
map.export(picture, "ear.png")

-- A woody stem with needles, and small bells around it in the upper half, ever smaller.
begin(64)
shape({ { -0.1, 0 }, { 0.1, 0 }, { 0.05, 0.95 }, { -0.05, 0.95 } }, { 0.6, 0.56, 0.5, 1 })
for i = 0, 15 do
    local at, side = 0.08 + 0.026 * i, i % 2 * 2 - 1
    shape({ { 0, at }, { side * 0.5, at + 0.03 }, { 0, at + 0.022 } }, { 0.72, 0.74, 0.66, 1 })
end
for i = 0, 21 do
    local at, side = 0.46 + 0.0245 * i, i % 2 * 2 - 1
    local wide = 0.85 * (1 - 0.75 * (i / 21) ^ 1.6)
    local light = 0.74 + 0.16 * ((i * 7) % 5) / 4
    shape({ { side * 0.05, at }, { side * wide, at - 0.006 }, { side * wide, at + 0.02 }, { side * 0.05, at + 0.03 } }, { light, light, light, 1 })
    shape({ { -side * 0.05, at + 0.008 }, { -side * wide * 0.75, at }, { -side * wide * 0.75, at + 0.02 }, { -side * 0.05, at + 0.03 } }, { light * 0.88, light * 0.88, light * 0.88, 1 })
end
map.export(picture, "spike.png")
