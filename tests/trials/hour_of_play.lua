-- An hour of play in the editor: a walker who turns, runs and jumps by dice through the park, among balls that roll, and
-- a picture every ten seconds. Prints the hash of each minute. hour_of_play.sh runs it and watches the memory.
project.open(project.tempCopy("../../projects/park"))
mesh.write(project.dir() .. "/models/ball.glb", { { shape = "ball", size = { 0.4, 0.4, 0.4 }, color = { 0.5, 0.1, 0.05 } } })
for i = 1, 8 do
    entity.add("ball" .. i, { Transform = { position = { 40 + 5 * i, 0.4, 56 } }, StaticMesh = { file = "models/ball.glb" },
                              Rolling = { radius = 0.4, friction = 0.3 } })
end

local state = 2463534242
local function dice()  -- from 0 to 1, the same in every run
    state = (1103515245 * state + 12345) % 2147483648
    return state / 2147483648
end

play.start { at = { 60, 60 } }
local yaw = 0
for minute = 1, 60 do
    for second = 1, 60 do
        yaw = (yaw + 120 * (dice() - 0.5)) % 360
        play.input { move = { 0.6 * (dice() - 0.5), 1 }, look = { yaw, 20 * (dice() - 0.7) }, run = dice() < 0.3, jump = dice() < 0.1 }
        if second % 10 == 0 then ui.wait(1) end
        play.step(minute * 3600 - 3600 + second * 60 - play.state().tick)
    end
    print("minute " .. minute .. " " .. play.hash())
end
local walked = play.state()
expect.equal(walked.tick, 216000)
expect.truthy(walked.walker.onGround or walked.walker.speed > 0)
play.stop()
