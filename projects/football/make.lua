-- A football pitch of 105 x 68 m with 627 million blades, mown in stripes and lined by the laws of the game,
-- in a terrain of 125 x 88 m. Writes project.json and maps/ beside itself.

local pitch = { x = 105, z = 68 }
local margin = 10                     -- metres of run-off on every side
local size = { pitch.x + 2 * margin, pitch.z + 2 * margin }
local blades = 627e6
local lineWidth = 0.12
local texel = 0.05
local columns, rows = size[1] / texel, size[2] / texel

-- A place on the pitch, from its corner, as a place on the terrain.
local function at(x, z) return { margin + x, margin + z } end

---------------------------------------------------------------------------------------------------------------- scene

project.new()
for _, name in ipairs(entity.list()) do entity.remove(name) end

entity.add("ground", { Terrain = { beyond = "fade", size = size, gridSpacing = 0.5, groundColor = { 0.09, 0.075, 0.045 } } })
entity.add("turf", { GrassField = {
    cellSize = 0.5, slices = 20, sharpness = 3,  -- frames add up, and smooth the grain
    species = { {
        name = "ryegrass", bladesPerM2 = blades / (pitch.x * pitch.z),
        height = 0.0315, heightVariation = 0.2, width = 0.003, bend = 0.25, segments = 2,
        leanDeg = 24, leanVariationDeg = 9, clumpSize = 0.3, clumpStrength = 0.25, translucency = 0.5, gloss = 0.45,
        rootColor = { 0.04, 0.06, 0.018 }, midColor = { 0.05, 0.12, 0.028 }, tipColor = { 0.075, 0.15, 0.04 },
    } },
}, HybridTiers = {  -- rays at middle distance are smoother than slices, and quicker (sward cost)
    minGeom = 1.5, maxGeom = 3.5, minBTF = 8, maxBTF = 13, tiersBy = "pixels", slicePixels = 3, middleTier = "raytraced",
} })
entity.add("sun", { Light = { azimuthDeg = 312, elevationDeg = 40 } })
-- A lamp on a stick that someone carries around, before the camera "low".
entity.add("lantern", { Transform = { position = { 55.7, 0.4, 25 } },
                        Light = { type = "point", color = { 1, 0.72, 0.4 }, intensity = 12, attenuation = 4, castShadows = false,
                                  orbitRadius = 0.7, orbitSeconds = 8 } })
-- Blades are thinner than a pixel almost everywhere: frames that add up are nearer to the truth than four samples, and
-- quicker (sward cost).
entity.add("antialias", { Antialias = { antialias = "temporal" } })
entity.add("sky", { Sky = { model = "atmosphere", turbidity = 1.4 } })
entity.add("haze", { Fog = { visibility = 9000 } })
entity.add("whole", { Camera = { eye = { 62.5, 40, -60 }, target = { 62.5, 0, 36 }, fovDeg = 55 } })
entity.add("human", { Camera = { eye = { 52, 1.7, 14 }, target = { 58, 0, 24 }, fovDeg = 55 } })
entity.add("walk", { CameraPath = { keys = {  -- someone walks onto the pitch and along it
    { name = "start", seconds = 0, eye = { 52, 1.7, 10 }, target = { 56, 0, 22 } },
    { name = "turn", seconds = 6, eye = { 55, 1.7, 19 }, target = { 64, 0, 26 } },
    { name = "end", seconds = 12, eye = { 63, 1.6, 25 }, target = { 76, 0.2, 30 } },
} } })
entity.add("low", { Camera = { eye = { 54, 0.25, 22 }, target = { 61, 0.1, 42 }, fovDeg = 55 } })

local density = "turf.GrassField.species[ryegrass].density"
local vegetation, orientation = "turf.GrassField.vegetation", "turf.GrassField.orientation"
local ground = "ground.Terrain.terrainMap"

----------------------------------------------------------------------------------------------------- where grass grows

local a, b = at(0, 0), at(pitch.x, pitch.z)
local whole = { x0 = a[1], z0 = a[2], x1 = b[1], z1 = b[2] }
local function onPitch(options)
    for name, value in sortedPairs(whole) do options[name] = value end
    return options
end

map.create { path = density, width = columns, height = rows, type = "u16", value = 0 }
map.rect(density, onPitch { value = 1 })

-- Lines are white pigment on leaves and soil. What lies between is white of no opacity, so that their edges stay white.
local paint, clear = { 0.94, 0.94, 0.91, 0.92 }, { 0.94, 0.94, 0.91, 0 }
map.create { path = vegetation, width = columns, height = rows, type = "u8", value = clear }
map.create { path = ground, width = columns, height = rows, type = "u8", value = { 0.36, 0.19, 0.14, 1 } }

-- Around the pitch: three metres of green matting, then the red run-off.
local apron = 3
map.rect(ground, { x0 = a[1] - apron, z0 = a[2] - apron, x1 = b[1] + apron, z1 = b[2] + apron,
                   value = { 0.16, 0.24, 0.11, 1 } })
map.noise(ground, { scale = 0.6, octaves = 4, amount = 0.18, seed = 3, mode = "multiply", channels = { 1, 2, 3 } })
map.rect(ground, onPitch { value = clear })

-- Worn, yellower grass before the goals and at the centre.
local worn = { 0.48, 0.45, 0.24, 0.4 }
for _, place in ipairs { at(4, 34), at(101, 34), at(52.5, 34) } do
    map.disc(vegetation, { x = place[1], z = place[2], radius = 4, soft = 5, value = worn })
end

-------------------------------------------------------------------------------------------------------- mown stripes

-- Twenty stripes of 5.25 m across the pitch, mown up and down: the grass leans along z, away in one, back in the next.
map.create { path = orientation, width = size[1] * 4, height = size[2] * 4, type = "u16", value = 0.5 }
local stripe = pitch.x / 20
for i = 0, 19 do
    local from, to = at(i * stripe, 0), at((i + 1) * stripe, pitch.z)
    map.rect(orientation, { x0 = from[1], z0 = from[2], x1 = to[1], z1 = to[2],
                            value = { 0.5, i % 2 == 0 and 0.95 or 0.05 } })
end
map.blur(orientation, 0.3)

--------------------------------------------------------------------------------------------------------------- lines

-- Every line belongs to the area that it bounds: it lies inside it.
local function mark(shape, options)
    options.value = paint
    map[shape](vegetation, options)
    map[shape](ground, options)
end
local function line(x0, z0, x1, z1)
    local from, to = at(x0, z0), at(x1, z1)
    mark("rect", { x0 = from[1], z0 = from[2], x1 = to[1], z1 = to[2] })
end
local function frame(x0, z0, x1, z1)
    line(x0, z0, x1, z0 + lineWidth)
    line(x0, z1 - lineWidth, x1, z1)
    line(x0, z0, x0 + lineWidth, z1)
    line(x1 - lineWidth, z0, x1, z1)
end
local function spot(x, z, radius)
    local centre = at(x, z)
    mark("disc", { x = centre[1], z = centre[2], radius = radius })
end
-- The part of a circle's line between two angles (0 towards +x, 90 towards +z).
local function arc(x, z, radius, fromDeg, toDeg)
    local points, steps = {}, 48
    for i = 0, steps do
        local angle = math.rad(fromDeg + (toDeg - fromDeg) * i / steps)
        local r = radius - lineWidth / 2
        points[#points + 1] = at(x + r * math.cos(angle), z + r * math.sin(angle))
    end
    mark("polyline", { points = points, width = lineWidth })
end

local middleX, middleZ = pitch.x / 2, pitch.z / 2
frame(0, 0, pitch.x, pitch.z)
line(middleX - lineWidth / 2, 0, middleX + lineWidth / 2, pitch.z)
spot(middleX, middleZ, 0.15)
local centre = at(middleX, middleZ)
mark("disc", { x = centre[1], z = centre[2], radius = 9.15, inner = 9.15 - lineWidth })

local goal = 7.32
for _, side in ipairs { { x = 0, sign = 1, facing = 0 }, { x = pitch.x, sign = -1, facing = 180 } } do
    local function area(depth)
        local half = goal / 2 + depth
        frame(math.min(side.x, side.x + side.sign * depth), middleZ - half, math.max(side.x, side.x + side.sign * depth), middleZ + half)
    end
    area(16.5)
    area(5.5)
    local spotX = side.x + side.sign * 11
    spot(spotX, middleZ, 0.12)
    local reach = math.deg(math.acos((16.5 - 11) / 9.15))  -- where the arc meets the penalty area
    arc(spotX, middleZ, 9.15, side.facing - reach, side.facing + reach)
end
local inLine = 3.7  -- degrees of a corner's arc that lie within the touch line or goal line, round end included
for _, corner in ipairs { { 0, 0, 0 }, { pitch.x, 0, 90 }, { pitch.x, pitch.z, 180 }, { 0, pitch.z, 270 } } do
    arc(corner[1], corner[2], 1, corner[3] + inLine, corner[3] + 90 - inLine)
end

project.saveAs(".")
