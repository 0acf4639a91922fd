-- The level of docs/editing.md, made by clicks and keys, with a picture of the editor at each step: NAME.png in the
-- folder OUT, which tools/readme_pictures.sh sets. Grass is thin meanwhile, so that clicks are answered at once.
local park = project.tempCopy(PARK)
project.new()

-- Where a place on the ground is in the window while the view is that of the camera `camera`.
local function screen(x, z)
    local eye, target = entity.get("camera.Camera.eye"), entity.get("camera.Camera.target")
    local y = entity.get("ground.Terrain.height") and map.at("ground.Terrain.height", x, z) or 0
    local fx, fy, fz = target[1] - eye[1], target[2] - eye[2], target[3] - eye[3]
    local length, flat = math.sqrt(fx * fx + fy * fy + fz * fz), math.sqrt(fx * fx + fz * fz)
    fx, fy, fz = fx / length, fy / length, fz / length
    local rx, rz = -fz * length / flat, fx * length / flat
    local ux, uy, uz = -rz * fy, rz * fx - rx * fz, rx * fy
    local dx, dy, dz = x - eye[1], y - eye[2], z - eye[3]
    local l, t, r, b = ui.rect("Viewport")
    local half = (b - t) / 2 / math.tan(math.rad(entity.get("camera.Camera.fovDeg")) / 2)
    local scale = half / (dx * fx + dy * fy + dz * fz)
    return (l + r) / 2 + (dx * rx + dz * rz) * scale, (t + b) / 2 - (dx * ux + dy * uy + dz * uz) * scale
end
local function click(x, z)
    local px, py = screen(x, z)
    ui.drag(px, py, px, py)
end
local function stroke(x1, z1, x2, z2)
    local ax, ay = screen(x1, z1)
    local bx, by = screen(x2, z2)
    ui.drag(ax, ay, bx, by)
end
local blades = "lawn.GrassField.species[lawn].bladesPerM2"
local function picture(name)
    entity.set(blades, 16000)
    ui.wait(3)
    ui.screenshot(OUT .. "/" .. name .. ".png")
    entity.set(blades, 300)
end
local function brush(tool, radius, strength, falloff)
    ui.click("Tools/" .. tool)
    ui.set("Brush/Radius", radius)
    ui.set("Brush/Strength", strength)
    ui.set("Brush/Falloff", falloff)
end

entity.set("sun.Light.azimuthDeg", 250)
entity.set("camera.Camera.eye", { 20, 6, 37 })
entity.set("camera.Camera.target", { 20, 1, 18 })
entity.set(blades, 300)
ui.set("Viewport/Camera", "camera")

ui.click("Outliner/ground")
brush("Raise", 8, 1, 1)
ui.set("Brush/Height", 1.5)
stroke(20, 13, 24, 13)
picture("edit-hill")

brush("Lower", 5, 1, 1)
ui.set("Brush/Height", 0.25)
stroke(17, 23, 20, 24)
entity.add("pond", { Water = { level = -0.3 } })
ui.click("Outliner/lawn")
ui.click("Tools/Add")
ui.click("Layers/Add rule")
ui.set("Layers/lawn.MapLayers.layers[rule].masks[mask].falloff", 4)
ui.set("Layers/lawn.MapLayers.layers[rule].name", "not steep")
picture("edit-layers")

ui.click("Tabs/Console")
ui.key("p")
for _, at in ipairs { { 22.5, 31 }, { 24.5, 27 }, { 27, 22 }, { 27.5, 16 }, { 31, 11 } } do click(at[1], at[2]) end
picture("edit-path")
ui.key("enter")

-- What stands in the level later comes from a script's hand; the bench is turned by its ring.
local function object(name, model, x, z, turn)
    entity.add(name, { Transform = { position = { x, 0, z } }, StaticMesh = { file = "models/" .. model .. ".glb", rotationDeg = { 0, turn or 0, 0 } } })
end
for _, model in ipairs { "bench", "stone1", "lamp", "tree1" } do
    ui.drop(park .. "/models/" .. model .. ".glb")
    ui.key("escape")
end
object("bench", "bench", 13, 22, -30)
object("stone", "stone1", 32, 24)
object("tree", "tree1", 10, 12)
object("tree-2", "tree1", 34, 12, 70)
ui.key("e")
ui.click("Outliner/bench")
picture("edit-turn")

ui.click("Outliner/stone")
ui.click("Menu/Object/Add Scatter")
ui.set("Inspector/scatter.Scatter.perHectare", 300)
entity.set("scatter.Scatter.size", { 0.2, 0.6 })
picture("edit-scatter")

object("lamp", "lamp", 24.5, 30.5)
ui.click("Outliner/lawn")
ui.click("Tabs/Accuracy")
ui.set("Accuracy/Against", "reference")
entity.set(blades, 16000)
for _ = 1, 100 do  -- the truth gets finer while nothing moves
    ui.wait(300)
    if ui.exists("Accuracy/samples") and tonumber(ui.get("Accuracy/samples"):match("^%d+")) >= 24 then break end
end
ui.screenshot(OUT .. "/edit-accuracy.png")
