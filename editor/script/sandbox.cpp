// What a script may do and how much: libraries, memory, instructions, time.
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <ctime>

#include "script/state.h"

namespace sward::script {
namespace {

constexpr uint64_t kHookEvery = 1000;  // instructions between two looks at the bounds
constexpr uint64_t kRefusalCost = 100'000;

// Of this thread, in seconds.
double processorTime() {
    timespec t{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}
double wallTime() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

void* allocate(void* user, void* block, size_t oldSize, size_t newSize) {
    State& state = *static_cast<State*>(user);
    if (!block) oldSize = 0;  // then it tells the kind of object
    if (newSize == 0) {
        std::free(block);
        state.memory -= oldSize;
        return nullptr;
    }
    if (newSize > oldSize && state.memory + (newSize - oldSize) > state.host.limits.memoryBytes) {
        state.instructions += kRefusalCost + state.memory;  // Lua looks through all that it holds for something to free
        return nullptr;
    }
    void* moved = std::realloc(block, newSize);
    if (moved) state.memory += newSize - oldSize;
    return moved;
}

// Level 0 is the running function (for the hook), 1 the one that called it (for calls of ours).
void count(lua_State* L, uint64_t instructions, int level);

// Once a bound is reached every further instruction raises, so that no pcall can carry on.
void countHook(lua_State* L, lua_Debug*) { count(L, kHookEvery, 0); }

// Which bound the script has reached; empty: none. A thread's own time is asked for only where so much has passed.
std::string boundReached(State& state) {
    const ScriptLimits& limits = state.host.limits;
    if (state.instructions > limits.instructions)
        return fmt::format("the script used up its {} instructions", limits.instructions);
    if (wallTime() - state.wallBegan > limits.seconds && processorTime() - state.timeBegan > limits.seconds)
        return fmt::format("the script used up its {} s of the processor's time", limits.seconds);
    if (state.host.stopped && state.host.stopped()) {
        state.stopped = true;
        return "interrupted";
    }
    return {};
}

void count(lua_State* L, uint64_t instructions, int level) {
    State& state = stateOf(L);
    const uint64_t most = state.host.limits.instructions;
    state.instructions = std::min(state.instructions, most + 1) + std::min(instructions, most + 1);
    if (state.limitHit.empty()) state.limitHit = boundReached(state);
    if (state.limitHit.empty()) return;
    lua_sethook(L, countHook, LUA_MASKCOUNT, 1);
    luaL_where(L, level);
    lua_pushstring(L, state.limitHit.c_str());
    lua_concat(L, 2);
    lua_error(L);
}

int print(lua_State* L, State& state) {
    std::string line;
    for (int i = 1; i <= lua_gettop(L); ++i) {
        size_t size = 0;
        const char* text = luaL_tolstring(L, i, &size);
        line.append(i > 1 ? "\t" : "").append(text, size);
        lua_pop(L, 1);
    }
    if (state.host.print)
        state.host.print(line);
    else
        std::fprintf(stdout, "%s\n", line.c_str());
    return 0;
}

// Finalizers run where no bound is looked at: there are none.
int setMetatable(lua_State* L, State&) {
    luaL_checktype(L, 1, LUA_TTABLE);
    luaL_argexpected(L, lua_isnil(L, 2) || lua_istable(L, 2), 2, "nil or table");
    if (lua_istable(L, 2)) {
        lua_pushstring(L, "__gc");
        if (lua_rawget(L, 2) != LUA_TNIL) raise(L, "scripts have no finalizers (__gc)");
        lua_pop(L, 1);
    }
    if (luaL_getmetafield(L, 1, "__metatable") != LUA_TNIL) raise(L, "cannot change a protected metatable");
    lua_settop(L, 2);
    lua_setmetatable(L, 1);
    return 1;
}

// Unwinding takes as long as thousands of instructions, and is paid as such.
constexpr uint64_t kErrorCost = 5000;

int endProtected(lua_State* L, int status, lua_KContext) {
    if (status == LUA_OK || status == LUA_YIELD) return lua_gettop(L);
    charge(L, kErrorCost);
    lua_pushboolean(L, false);
    lua_insert(L, -2);
    return 2;
}
int protectedCall(lua_State* L, State&) {
    luaL_checkany(L, 1);
    lua_pushboolean(L, true);
    lua_insert(L, 1);
    return endProtected(L, lua_pcallk(L, lua_gettop(L) - 2, LUA_MULTRET, 0, 0, endProtected), 0);
}

// Lua would call the handler from within the hook that looks at the bound, where no bound is looked at: here it is
// called once the function has been left. The function cannot yield.
int handledCall(lua_State* L, State&) {
    luaL_checkany(L, 2);
    lua_pushvalue(L, 1);
    lua_insert(L, 3);  // function, handler, function, arguments
    if (lua_pcall(L, lua_gettop(L) - 3, LUA_MULTRET, 0) == LUA_OK) {
        lua_pushboolean(L, true);
        lua_replace(L, 2);
        return lua_gettop(L) - 1;
    }
    charge(L, kErrorCost);
    lua_pushvalue(L, 2);
    lua_insert(L, -2);
    lua_call(L, 1, 1);
    lua_pushboolean(L, false);
    lua_insert(L, -2);
    return 2;
}

// The library's function below its arguments, which is the upvalue of what stands in for it.
int callWrapped(lua_State* L) {
    lua_pushvalue(L, lua_upvalueindex(1));
    lua_insert(L, 1);
    lua_call(L, lua_gettop(L) - 1, LUA_MULTRET);
    return lua_gettop(L);
}

// A new coroutine's first instructions are not looked at: it pays for them in advance.
int payForCoroutine(lua_State* L) {
    charge(L, kHookEvery);
    return callWrapped(L);
}

void chargeSteps(lua_State* L, double steps) {
    if (steps > 0) charge(L, static_cast<uint64_t>(std::min(steps, 1e18)));
}

// What the table library works off in one call are elements that are there, or a range that the call names: a length
// that a metatable states would be neither.
double ownLength(lua_State* L) {
    luaL_checktype(L, 1, LUA_TTABLE);
    if (luaL_getmetafield(L, 1, "__len") != LUA_TNIL) raise(L, "the table's length is not its own (__len)");
    return static_cast<double>(lua_rawlen(L, 1));
}
// table.insert(t, at, value), table.remove(t, at): what lies behind moves. The second upvalue is the number of
// arguments with which nothing does.
int payForShift(lua_State* L) {
    const double length = ownLength(L), at = luaL_optnumber(L, 2, length);
    if (lua_gettop(L) != lua_tointeger(L, lua_upvalueindex(2))) chargeSteps(L, length - at);
    return callWrapped(L);
}
// Comparisons without a function of the script's are no instructions.
int payForSort(lua_State* L) {
    const double length = ownLength(L);
    chargeSteps(L, 4 * length * std::log2(length + 2));
    return callWrapped(L);
}
// table.move(t, from, to, …), table.concat(t, separator, from, to), table.unpack(t, from, to): ranges. The second
// upvalue is the argument in which a range begins.
int payForRange(lua_State* L) {
    const int first = static_cast<int>(lua_tointeger(L, lua_upvalueindex(2)));
    const bool given = !lua_isnoneornil(L, first + 1);
    chargeSteps(L, (given ? luaL_checknumber(L, first + 1) : ownLength(L)) - luaL_optnumber(L, first, 1));
    return callWrapped(L);
}
// string.rep of nothing still counts.
int payForRepeats(lua_State* L) {
    chargeSteps(L, luaL_checknumber(L, 2) / 8);
    return callWrapped(L);
}

// argument: the closure's second upvalue.
void wrap(lua_State* L, const char* table, const char* name, lua_CFunction with, int argument = 0) {
    lua_getglobal(L, table);
    lua_getfield(L, -1, name);
    lua_pushinteger(L, argument);
    lua_pushcclosure(L, with, 2);
    lua_setfield(L, -2, name);
    lua_pop(L, 1);
}

void openLibraries(lua_State* L) {
    const luaL_Reg libraries[] = {{LUA_GNAME, luaopen_base},       {LUA_STRLIBNAME, luaopen_string},
                                  {LUA_TABLIBNAME, luaopen_table}, {LUA_MATHLIBNAME, luaopen_math},
                                  {LUA_UTF8LIBNAME, luaopen_utf8}, {LUA_COLIBNAME, luaopen_coroutine}};
    for (const luaL_Reg& library : libraries) {
        luaL_requiref(L, library.name, library.func, 1);
        lua_pop(L, 1);
    }
    for (const char* name : {"load", "loadfile", "dofile", "collectgarbage", "warn"}) {
        lua_pushnil(L);
        lua_setglobal(L, name);
    }
    lua_getglobal(L, LUA_STRLIBNAME);
    lua_pushnil(L);
    lua_setfield(L, -2, "dump");
    lua_pop(L, 1);
    lua_register(L, "print", luaCall<print>);
    lua_register(L, "setmetatable", luaCall<setMetatable>);
    lua_register(L, "pcall", luaCall<protectedCall>);
    lua_register(L, "xpcall", luaCall<handledCall>);
    wrap(L, LUA_COLIBNAME, "create", payForCoroutine);
    wrap(L, LUA_COLIBNAME, "wrap", payForCoroutine);
    wrap(L, LUA_TABLIBNAME, "move", payForRange, 2);
    wrap(L, LUA_TABLIBNAME, "concat", payForRange, 3);
    wrap(L, LUA_TABLIBNAME, "unpack", payForRange, 2);
    wrap(L, LUA_TABLIBNAME, "insert", payForShift, 2);  // two arguments append
    wrap(L, LUA_TABLIBNAME, "remove", payForShift, 1);  // one takes the last
    wrap(L, LUA_TABLIBNAME, "sort", payForSort);
    wrap(L, LUA_STRLIBNAME, "rep", payForRepeats);
}

int openAll(lua_State* L) {
    openLibraries(L);
    for (const auto open : {openProjectCalls, openEntityCalls, openCameraCalls, openFilmCalls, openMapCalls,
                            openMapShapeCalls, openMeshCalls, openBakeCalls, openBrushCalls, openEditCalls,
                            openPlayCalls, openUiCalls, openExpectCalls, openHelp})
        open(L);
    return 0;
}

// "token:12: text" as the error of line 12 of the file.
Error located(const std::string& message, const std::string& token, const std::filesystem::path& file) {
    Error error = failed(message);
    if (!message.starts_with(token + ":")) return error;
    const char* digits = message.c_str() + token.size() + 1;
    char* end = nullptr;
    const long line = std::strtol(digits, &end, 10);
    if (end == digits || *end != ':') return error;
    error.file = file.string();
    error.line = static_cast<int>(line);
    error.message = end + (end[1] == ' ' ? 2 : 1);
    return error;
}

Error failureOf(lua_State* L, int status, const std::string& token, const std::filesystem::path& file) {
    State& state = stateOf(L);
    const bool memory = status == LUA_ERRMEM;
    std::string message = lua_isstring(L, -1) ? lua_tostring(L, -1) : "the script raised an error that is no string";
    if (memory)
        message = fmt::format("the script needs more than its {} MiB of memory", state.host.limits.memoryBytes >> 20);
    Error error = located(message, token, file);
    if (!state.limitHit.empty() && !message.ends_with(state.limitHit)) error.message = state.limitHit;
    if (error.file.empty()) error.file = file.string();
    if (state.stopped) error.code = ExitCode::Interrupted;
    // A call's error keeps its exit code if it is what ended the script.
    if (state.lastError && state.limitHit.empty() && message.ends_with(state.lastError->text()))
        error.code = state.lastError->code;
    return error;
}

}  // namespace

LuaPtr openLua(State& state) {
    LuaPtr L(lua_newstate(allocate, &state));
    if (!L) return nullptr;
    State* self = &state;
    std::memcpy(lua_getextraspace(L.get()), &self, sizeof self);
    lua_pushcfunction(L.get(), openAll);
    if (lua_pcall(L.get(), 0, 0, 0) != LUA_OK) return nullptr;
    return L;
}

void charge(lua_State* L, uint64_t instructions) { count(L, instructions, 1); }

Status runChunk(lua_State* L, int nargs, const std::string& token, const std::filesystem::path& file) {
    State& state = stateOf(L);
    state.instructions = 0;
    state.limitHit.clear();
    state.stopped = false;
    state.wallBegan = wallTime(), state.timeBegan = processorTime();
    state.lastError.reset();
    lua_sethook(L, countHook, LUA_MASKCOUNT, static_cast<int>(kHookEvery));
    const int status = lua_pcall(L, nargs, LUA_MULTRET, 0);
    lua_sethook(L, nullptr, 0, 0);
    if (status == LUA_OK && state.limitHit.empty()) return {};
    Error error = status == LUA_OK ? failed(state.limitHit).at(file) : failureOf(L, status, token, file);
    lua_settop(L, 0);
    return error;
}

}  // namespace sward::script
