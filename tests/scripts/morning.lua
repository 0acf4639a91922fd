-- A level made by hand, from File > New to the saved folder: widgets, keys and the pointer alone change anything here,
-- and all other calls only look.
local park = project.tempCopy("../../projects/park")  -- objects to drop, and a folder to make the level beside
local dir = park:gsub("park$", "glade")

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
local function pull(label, dx, dy)
    local l, t, r, b = ui.rect(label)
    ui.drag((l + r) / 2, (t + b) / 2, (l + r) / 2 + dx, (t + b) / 2 + dy)
end
local function add(name, ...)
    ui.set("Outliner/New entity", name)
    for _, component in ipairs { ... } do ui.set("Inspector/Add component", component) end
end
local function blades()  -- millions that are drawn, as the status bar has them
    return tonumber(ui.get("Status/Blades"):match("^([%d.]+) M$"))
end

-- A new project from a template, level and 40 m wide, seen from above its southern edge.
ui.click("Menu/File/New...")
ui.click("Files/Template/field")
expect.equal({ ui.get("Files/Size"), ui.get("Files/Relief") }, { "40", "0" })
ui.set("Files/Path", dir)
expect.equal(project.dir(), dir)
ui.set("Inspector/camera.Camera.eye", "[20, 24, 46]")
ui.set("Inspector/camera.Camera.target", "[20, 0, 20]")
ui.set("Viewport/Camera", "camera")
local full = blades()
expect.near(full, 6.4, 0.01)

-- Two hills and a hollow: the first stroke makes the heights.
for _, hand in ipairs { { "Raise", 7, 2.4, { 9, 10, 12, 12 } }, { "Raise", 7, 2.4, { 32, 12, 30, 14 } },
                        { "Lower", 6, 0.5, { 27, 28, 30, 29 } } } do
    ui.click("Tools/" .. hand[1])
    ui.set("Brush/Radius", hand[2])
    ui.set("Brush/Falloff", 1)
    ui.set("Brush/Height", hand[3])
    stroke(table.unpack(hand[4]))
end
expect.less(1.5, map.at("height", 10.5, 11))
expect.less(1.5, map.at("height", 31, 13))
expect.less(map.at("height", 28.5, 28.5), -0.5)
expect.equal(map.at("height", 4, 36), 0)

-- A picture of heights into the far corner: looked at, placed, seen as it would become, taken.
ui.click("Menu/Maps/Place Heights...")
ui.set("Image/Path", park .. "/maps/ground.height.exr")
expect.truthy(ui.get("Image/Told"):find("float", 1, true), ui.get("Image/Told"))
expect.equal(ui.get("Image/Preview"), park .. "/maps/ground.height.exr")
ui.click("Image/Place")
for label, metres in pairs { X = 32, Z = 0, Width = 8, Depth = 7, Falloff = 0.5 } do ui.set("Place heights/" .. label, metres) end
local level = map.hash("height")
ui.screenshot("morning_heights.png")
expect.equal(map.hash("height"), level, "nothing is taken yet")
ui.click("Place heights/Accept")
expect.truthy(map.hash("height") ~= level)
expect.equal(map.at("height", 4, 36), 0, "in its corner alone")
expect.truthy(map.at("height", 36, 3) ~= 0)

-- No grass above 35 degrees is what a rule begins with.
local density = "lawn.GrassField.species[lawn].density"
local painted = map.hash(density)
ui.click("Tools/Add")
ui.click("Layers/Add rule")
local mask = "lawn.MapLayers.layers[rule].masks[mask]."
expect.equal({ entity.get(mask .. "by"), entity.get(mask .. "from"), entity.get(mask .. "to") }, { "slope", 0, 35 })
local flat = blades()
expect.less(flat, full, "steep ground is bare")

-- A winding path, bare too.
ui.key("p")
for _, at in ipairs { { 4, 36 }, { 12, 29 }, { 16, 20 }, { 21, 13 }, { 22, 4 } } do click(at[1], at[2]) end
ui.key("enter")
expect.equal(#entity.get("path.GroundPath.points"), 5)
expect.near(entity.get("path.GroundPath.points[0].at")[1], 4, 0.1)
expect.less(blades(), flat - 0.05, "none grow on the path")
expect.equal(map.hash(density), painted, "what is painted stays")

-- Daisies beside it: a new species of flowers is bare until it is painted.
add("daisies", "Flowers")
expect.equal(map.mean("daisies.Flowers.density"), 0)
ui.set("Inspector/daisies.Flowers.flowersPerM2", 25)
ui.set("Brush/Map", "daisies.Flowers.density")
ui.click("Tools/Add")
ui.set("Brush/Strength", 1)
stroke(9, 35, 15, 32)
expect.less(0, map.mean("daisies.Flowers.density"))

-- Stones and benches: dropped onto the window, placed by clicks, turned and scaled by their handles.
ui.drop(park .. "/models/bench.glb")
ui.drop(park .. "/models/stone1.glb")
for _, at in ipairs { { 17, 26 }, { 19, 27.5 } } do click(at[1], at[2]) end
ui.key("escape")
ui.click("Objects/bench.glb")
for _, at in ipairs { { 20, 21 }, { 24, 13 } } do click(at[1], at[2]) end
ui.key("escape")
local placed = { "bench", "bench-2", "stone1", "stone1-2" }
expect.equal(entity.list("StaticMesh"), placed)
expect.near(entity.get("bench.Transform.position")[1], 20, 0.1)
ui.key("e")
ui.click("Viewport/Object bench")
pull("Viewport/Gizmo turn y", 60, 0)
expect.truthy(math.abs(entity.get("bench.StaticMesh.rotationDeg")[2]) > 10)
ui.key("r")
ui.click("Viewport/Object stone1")
pull("Viewport/Gizmo scale", 40, -40)
expect.less(1.2, entity.get("stone1.StaticMesh.scale"))
ui.key("ctrl+d"); ui.key("ctrl+d")
expect.equal(#entity.list("StaticMesh"), 6)
ui.key("ctrl+z"); ui.key("ctrl+z")
expect.equal(entity.list("StaticMesh"), placed)

-- A pond in the hollow, stones all over, a lamp by the path.
add("pond", "Water")
ui.set("Inspector/pond.Water.level", -0.3)
ui.click("Outliner/stone1")
ui.click("Menu/Object/Add Scatter")
expect.equal(entity.get("scatter.Scatter.meshes[stone1].file"), "models/stone1.glb")
add("lamp", "Transform", "Light")
ui.set("Inspector/lamp.Light.type", "point")
ui.set("Inspector/lamp.Transform.position", "[12, 1.5, 24]")
expect.equal(entity.get("lamp.Light.type"), "point")

-- A camera from the view, which has gone round the middle.
local px, py = screen(20, 20)
ui.drag(px, py, px + 120, py - 60, "alt")
add("overlook", "Camera")
ui.click("Inspector/overlook.Camera/Take the view")
expect.equal(ui.get("Viewport/Camera"), "overlook")
expect.truthy(math.abs(entity.get("overlook.Camera.eye")[1] - 20) > 5)
ui.screenshot("morning.png")

-- A fit to a budget begins beside the window and is stopped: it measures for minutes (what one finds is previewed and
-- adopted in tests/editor/accuracy), and changes nothing until it is adopted.
local measured = project.hash()
ui.set("Accuracy/Budget", 40)
ui.click("Accuracy/Fit to budget")
ui.wait(20)
ui.click("Accuracy/Stop fit")
expect.truthy(ui.exists("Accuracy/Fit to budget"))
expect.equal(project.hash(), measured)

-- A walk along the path leaves all as it is.
local before = map.hash("height")
ui.click("Outliner/path")
ui.click("Menu/Play/Walk Along Path")
ui.wait(10)
local walker = play.state().walker
expect.truthy(play.state().walking)
expect.less(0.2, math.sqrt((walker.x - 4) ^ 2 + (walker.z - 36) ^ 2))
ui.key("f5")
expect.equal(ui.get("Play/State"), "stopped")
expect.equal(map.hash("height"), before)

-- Saved, exported, and opened again: all is there, and a save has nothing to write.
ui.key("ctrl+s")
expect.truthy(ui.get("Status/Message"):match("^saved: %d+ files written$"), ui.get("Status/Message"))
expect.truthy(not project.dirty())
ui.click("Menu/File/Export...")
ui.set("Files/Blades Within", 18)
ui.click("Files/Export")
for _ = 1, 500 do
    if not ui.exists("Status/Exporting") then break end
    ui.wait(5)
end
expect.truthy(ui.get("Status/Message"):find("glade.glb", 1, true), ui.get("Status/Message"))

local function level()
    local all = {}
    for _, name in ipairs(entity.list()) do all[name] = entity.get(name) end
    for _, path in ipairs { "ground.Terrain.height", density, "daisies.Flowers.density" } do all[path] = map.hash(path) end
    return all
end
local made = level()
ui.click("Menu/File/Open...")
ui.set("Files/Path", dir)
expect.equal(level(), made)
ui.key("ctrl+s")
expect.equal(ui.get("Status/Message"), "saved: nothing had changed")
