-- Walks, runs, jumps, stops at the edge, pushes a ball; twice the same; and leaves the project exactly as it was.
project.open(project.tempCopy("../../projects/park"))
mesh.write(project.dir() .. "/models/ball.glb", { { shape = "ball", size = { 0.4, 0.4, 0.4 }, color = { 0.5, 0.1, 0.05 } } })
entity.add("ball", { Transform = { position = { 60, 0.4, 56 } }, StaticMesh = { file = "models/ball.glb" },
                     Rolling = { radius = 0.4, friction = 0.4 } })
brush.select { map = "species[lawn].density", mode = "subtract", radius = 2 }
brush.stroke { { 60, 40 }, { 70, 45 } }
edit.undo()
local lawn, height = map.hash("species[lawn].density"), entity.get("ball.Transform.position")

local function walk()
    local hashes = {}
    play.start { at = { 60, 60 } }
    play.input { move = { 0, 1 }, look = { 0, -10 } }  -- north, to the ball
    play.step(300)
    local ball = play.state().rolling.ball
    expect.less(ball.z, 55.5, "the ball was not pushed")
    play.input { move = { 0, 1 }, look = { 90, 0 }, run = true, jump = true }
    play.step(2)
    expect.equal(play.state().walker.onGround, false, "it did not jump")
    expect.equal(#play.state().contacts, 1, "only the ball is on the ground")
    hashes[1] = play.hash()
    play.input { move = { 0, 1 }, run = true }
    play.step(60 * 60)
    local w = play.state().walker
    expect.near(w.x, 120 - 0.3, 1e-9, "it stops at the edge")
    expect.near(w.yaw, 90, 1e-9, "the look stays")
    expect.near(play.state().time, 3902 / 60, 1e-9)
    hashes[2] = play.hash()
    play.stop()
    return hashes
end
local first, again = walk(), walk()
expect.equal(first, again, "the same inputs, another walk")

-- Nothing is saved, taken back or changed meanwhile.
play.start()
for _, refused in ipairs { project.save, edit.undo, edit.redo, function() entity.set("ball.Rolling.radius", 1) end,
                           function() map.fill("species[lawn].density", 0) end, play.start } do
    local ok, message = pcall(refused)
    expect.equal(ok, false)
    expect.truthy(message:find("play", 1, true), message)
end
play.step(10)
play.stop()
expect.equal(play.state(), nil)
expect.equal(entity.get("ball.Transform.position"), height)
expect.equal(map.hash("species[lawn].density"), lawn)
expect.truthy(project.dirty())
expect.truthy(edit.redo(), "what could be done again still can")
print("walked " .. first[2])
