-- A path takes a key from the view, in one step of undo, and the view goes along it.
project.new()
entity.remove("lawn")  -- no grass to bake
entity.add("walk", { CameraPath = { keys = {
    { name = "start", seconds = 0, eye = { 2, 1.7, 2 }, target = { 6, 0, 9 } },
    { name = "end", seconds = 12, eye = { 9, 1.6, 8 }, target = { 16, 0.2, 13 } },
} } })
ui.wait(3)
ui.click("Outliner/walk")
ui.wait(2)
ui.click("Inspector/walk.CameraPath/Key from view")
ui.wait(2)
expect.equal(entity.get("walk.CameraPath.keys[key].seconds"), 14)
expect.truthy(ui.exists("Inspector/walk.CameraPath.keys[key]"))
ui.set("Inspector/walk.CameraPath/Second", "9")
ui.wait(2)
edit.undo()
ui.wait(2)
expect.truthy(not ui.exists("Inspector/walk.CameraPath.keys[key]"))
