-- Empty field: a lawn, on level ground or on gentle waves.
-- 40 m, 0 m of relief

local density, height = "lawn.GrassField.species[lawn].density", "ground.Terrain.height"
local texels = 256
while texels < 8 * size and texels < 4096 do texels = 2 * texels end

entity.set("ground.Terrain.size", { size, size })
entity.set(density, nil)
map.create { path = density, width = texels, height = texels, type = "u16", value = 1 }
if relief > 0 then
    local points = math.max(64, math.min(1024, math.floor(size * 2)))
    map.create { path = height, width = points, height = points, type = "f32" }
    map.noise(height, { scale = math.max(12, size / 3), octaves = 3, amount = relief, seed = 3, mode = "set" })
    map.blur(height, 2)
end
local function ground(x, z) return relief > 0 and map.at(height, x, z) or 0 end
local middle = size / 2
entity.set("camera.Camera.eye", { middle - 6, ground(middle - 6, middle + 9) + 1.7, middle + 9 })
entity.set("camera.Camera.target", { middle, ground(middle, middle) + 0.3, middle })
entity.set("sun.Light.azimuthDeg", 300)  -- behind the camera's shoulder: against it a lawn is dark
