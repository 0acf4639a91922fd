// What scripts cannot do: run for ever, take all memory, get out of Lua.
#include "editor/script/cage.h"

namespace sward {
namespace {

using test::Cage;
using test::says;

TEST(ScriptSandbox, DangerousLibrariesAreNotThere) {
    Cage c;
    EXPECT_EQ(c.fault(R"(
        for _, name in ipairs{'os', 'io', 'debug', 'package', 'require', 'load', 'loadfile', 'dofile', 'collectgarbage', 'loadstring'} do
            expect.equal(_G[name], nil, name)
        end
        expect.equal(string.dump, nil)
        expect.equal(('').dump, nil))"),
              "");
}

TEST(ScriptSandbox, CompiledLuaIsRefused) {
    Cage c;
    EXPECT_TRUE(says(c.fault(std::string("\x1bLua\x54\x00", 6)), "text only"));
}

TEST(ScriptSandbox, FinalizersAreRefused) {
    Cage c;
    EXPECT_TRUE(says(c.fault("setmetatable({}, {__gc = function() while true do end end})"), "finalizers"));
    EXPECT_EQ(c.fault("local t = setmetatable({}, {__index = {a = 1}}) expect.equal(t.a, 1)"), "");
    EXPECT_TRUE(says(c.fault("setmetatable(setmetatable({}, {__metatable = 1}), {})"), "protected"));
}

TEST(ScriptSandbox, ProtectedCallsWork) {
    Cage c;
    EXPECT_EQ(c.fault(R"(
        expect.equal({pcall(function(a) return a, 'x' end, 1)}, {true, 1, 'x'})
        expect.equal({pcall(error, {code = 5})}, {false, {code = 5}})
        local co = coroutine.wrap(function() return pcall(function() coroutine.yield(1) error('late', 0) end) end)
        expect.equal(co(), 1)
        expect.equal({co()}, {false, 'late'})
        expect.equal({xpcall(function(a, b) return a + b, 'x' end, print, 1, 2)}, {true, 3, 'x'})
        expect.equal({xpcall(function() error({code = 5}) end, function(e) return e.code end)}, {false, 5}))"),
              "");
}

TEST(ScriptSandbox, EndlessScriptsEndAndSayTheirBound) {
    Cage c;
    c.host.limits.instructions = 2'000'000;
    const std::string bound = "the script used up its 2000000 instructions";
    for (const char* endless : {
             "while true do end",
             "repeat until false",
             "local function f() return f() end f()",
             "while true do pcall(function() while true do end end) end",
             "pcall(function() while true do end end)",
             "while true do pcall(error) end",
             "xpcall(function() while true do end end, function() while true do end end)",
             "while true do coroutine.wrap(function() for i = 1, 900 do end end)() end",
             "while true do local co = coroutine.create(function() while true do end end) coroutine.resume(co) end",
             "local t = setmetatable({}, {__index = function() while true do end end}) local x = t.a",
             "local t = setmetatable({}, {__close = function() while true do end end}) do local x <close> = t end",
             "table.move({}, 1, 1 << 53, 2)",
             "table.sort({3, 2, 1}, function() while true do end end)",
             "table.concat(setmetatable({}, {__index = type}), '', 1, 1 << 53)",
             "table.unpack(setmetatable({}, {__index = type}), 1, 1 << 53)",
             "string.rep('', 1 << 53)",
             "local t = {} for i = 1, 10000 do t[i] = i end while true do table.insert(t, 1, 0) table.remove(t, 1) end",
             "local t = {} for i = 1, 10000 do t[i] = i % 7 end while true do table.sort(t) end",
             "local s = ('x'):rep(1 << 20) while true do pcall(function() local t = s while true do t = t .. t end "
             "end) end",
             "print(setmetatable({}, {__tostring = function() while true do end end}))",
             "project.new() while true do map.noise('density', {scale = 1, octaves = 16}) end",
             "project.new() while true do map.disc('density', {x = 20, z = 20, radius = 30}) end",
             "project.new() while true do map.mean('density') end",
             "project.new() map.fill('density', function() while true do end end)",
             "project.new() local i = 0 while true do i = i + 1 entity.add('e' .. i) end",
         })
        EXPECT_TRUE(says(c.fault(endless), bound)) << endless << "\n" << c.fault(endless);
}

TEST(ScriptSandbox, ALengthThatAMetatableStatesIsNotWorkedOff) {
    Cage c;
    for (const char* call : {"table.insert(t, 1, 0)", "table.insert(t, 0)", "table.remove(t, 1)", "table.remove(t)",
                             "table.concat(t)", "table.unpack(t)", "table.sort(t)"})
        EXPECT_TRUE(
            says(c.fault(std::string("local t = setmetatable({}, {__len = function() return 1 << 62 end}) ") + call),
                 "not its own"))
            << call;
    EXPECT_EQ(c.fault(R"(
        local t = {}
        for i = 1, 100000 do table.insert(t, i) end          -- appending costs nothing that grows
        for i = 1, 99990 do table.remove(t) end
        table.insert(t, 2, 'x')
        expect.equal(table.concat(t, ' '), '1 x 2 3 4 5 6 7 8 9 10')
        expect.equal({table.remove(t, 2), table.remove(t), #t}, {'x', 10, 9})
        table.sort(t, function(a, b) return a > b end)
        expect.equal({table.unpack(t, 1, 3)}, {9, 8, 7})
        expect.equal(('ab'):rep(3, '-'), 'ab-ab-ab'))"),
              "");
}

TEST(ScriptSandbox, TimeIsBounded) {
    Cage c;
    c.host.limits.seconds = 0.2;
    const std::string bound = "the script used up its 0.2 s of the processor's time";
    EXPECT_TRUE(says(c.fault("while true do end"), bound));
    EXPECT_TRUE(says(c.fault("local s = ('x'):rep(1e6) while true do pcall(string.reverse, s) end"), bound));
}

TEST(ScriptSandbox, AHostMayStopAScript) {
    Cage c;
    int asked = 0;
    c.host.stopped = [&] { return ++asked > 50; };
    const Status ended = c.run("while true do pcall(function() while true do end end) end");
    ASSERT_FALSE(ended);
    EXPECT_EQ(ended.error().code, ExitCode::Interrupted);
    c.host.stopped = {};
    EXPECT_EQ(c.fault("local x = 1"), "");
}

TEST(ScriptSandbox, TheBoundIsToldWithTheLineThatReachedIt) {
    Cage c;
    c.host.limits.instructions = 100'000;
    EXPECT_TRUE(says(c.fault("local x = 0\nwhile true do\n  x = x + 1\nend"), "test.lua:3: the script used up"));
}

TEST(ScriptSandbox, TooMuchMemoryIsRefusedWithTheBound) {
    Cage c;
    c.host.limits.memoryBytes = size_t(32) << 20;
    for (const char* greedy : {
             "local t = {} for i = 1, 1e8 do t[i] = i end",
             "local s = 'x' while true do s = s .. s end",
             "string.rep('x', 1 << 30)",
             "local t = {} for i = 1, 1e8 do t[i] = {} end",
         })
        EXPECT_TRUE(says(c.fault(greedy), "more than its 32 MiB of memory")) << greedy << "\n" << c.fault(greedy);
    EXPECT_EQ(c.fault("expect.truthy(not pcall(string.rep, 'x', 1 << 30))"), "");  // may be caught: it did no harm
}

TEST(ScriptSandbox, DeepRecursionEndsTheScriptOnly) {
    Cage c;
    EXPECT_TRUE(says(c.fault("local function f() return 1 + f() end f()"), "stack overflow"));
    EXPECT_NE(c.fault("local t = {} for i = 1, 1000 do t = {t} end local u = {} for i = 1, 1000 do u = {u} end "
                      "expect.equal(t, u)"),
              "");
    EXPECT_NE(c.fault("string.rep('(', 1000000):find(string.rep('(', 1000))"), "");
}

TEST(ScriptSandbox, MapsBeyondTheirBoundAreRefused) {
    Cage c;
    EXPECT_TRUE(
        says(c.fault("project.new() map.create{path = 'vegetation', width = 16384, height = 16384, type = 'f32'}"),
             "the most is 1024"));
    c.host.limits.mapBytes = size_t(1) << 20;
    EXPECT_TRUE(says(c.fault("project.new() map.create{path = 'density', width = 2048, height = 2048}"),
                     "a script may make them 1"));
    EXPECT_TRUE(says(c.fault("project.new() map.create{path = 'density', width = 99999, height = 1}"), "1 to 16384"));
}

}  // namespace
}  // namespace sward
