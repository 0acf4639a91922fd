-- The world of large_world.sh in the editor: opened, sculpted, undone, saved and walked through. Prints a line as each
-- step ends.
project.open("world")
camera.use("camera")
ui.wait(1)
print "opened"
local before = map.at("height", 8200, 8300)
brush.select { map = "height", mode = "raise", radius = 60, value = 5, strength = 1, falloff = 1 }
brush.stroke { { 8100, 8200 }, { 8300, 8400 } }
ui.wait(1)
print "painted"
local painted = map.at("height", 8200, 8300)
expect.truthy(painted > before + 1)
edit.undo()
ui.wait(1)
expect.equal(map.at("height", 8200, 8300), before)
print "undone"
edit.redo()
ui.wait(2)
print "redone"
ui.wait(2)
project.save()
print "saved"
ui.wait(2)
project.open("world")
expect.equal(map.at("height", 8200, 8300), painted)
edit.undo()
ui.wait(1)
play.start { at = { 8000, 8000 } }
play.input { move = { 0, 1 }, look = { 45, 0 }, run = true }
play.step(1)
ui.wait(1)
print "walks"
for frame = 1, 120 do
    play.step(12)
    ui.wait(1)
    print "frame"
end
play.stop()
print "walked"
