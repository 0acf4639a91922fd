// What the calls of a script share: the host, the bounds and the files it may reach; and how C++ answers Lua.
// Does not: define any call; each family has a file of its own.
#pragma once
#include <lauxlib.h>
#include <lua.h>
#include <lualib.h>

#include <optional>

#include "script/script.h"

namespace sward::script {

struct State {
    ScriptHost& host;
    std::filesystem::path folder;                 // of the script, canonical
    std::vector<std::filesystem::path> tempDirs;  // made by tempCopy and new; removed at the end
    uint64_t instructions = 0;                    // used so far
    size_t memory = 0;                            // held now
    double wallBegan = 0, timeBegan = 0;          // when the chunk began: by the clock, and of this thread; seconds
    bool stopped = false;                         // ScriptHost::stopped ended it
    std::string limitHit;                         // message of the bound that ended the script
    std::optional<Error> lastError;               // the last error a call raised, with its exit code
    std::shared_ptr<void> lastMap;                // the map last read (map_args.cpp), for calls texel by texel

    // Nothing is used yet; the host must outlive it.
    explicit State(ScriptHost& h) : host(h) {}
    ~State();
    // The host's document.
    Document& document() { return host.document; }
    std::span<const ComponentRow> rows() { return host.document.tables().components; }
};
// That a Lua state was opened with.
State& stateOf(lua_State* L);

// --- sandbox.cpp -------------------------------------------------------------------------------------------------
// A Lua state with the allowed libraries and all calls, bound to state. Null if there is no memory.
struct CloseLua {
    // Closes it; finalizers of Lua values run.
    void operator()(lua_State* L) const { lua_close(L); }
};
using LuaPtr = std::unique_ptr<lua_State, CloseLua>;
// A Lua state with the allowed libraries and all calls, bound to `state`, which must outlive it. Null if there is no
// memory.
LuaPtr openLua(State& state);
// Counts work against the bound of instructions; raises when it is exceeded.
void charge(lua_State* L, uint64_t instructions);
// Calls the function below the nargs arguments on top of the stack; its results stay. The bound of instructions begins
// anew. `token` is what Lua's messages call the chunk: those lines become lines of `file` in the error.
Status runChunk(lua_State* L, int nargs, const std::string& token, const std::filesystem::path& file);

// --- raising and answering ---------------------------------------------------------------------------------------
[[noreturn]] void raise(lua_State* L, const Error& error);
[[noreturn]] void raise(lua_State* L, const std::string& message);
// Goes on, or raises the error with its exit code.
inline void orRaise(lua_State* L, const Status& status) {
    if (!status) raise(L, status.error());
}
// The value, or raises.
template <class T>
T orRaise(lua_State* L, Result<T> result) {
    if (!result) raise(L, result.error());
    return std::move(*result);
}
const Project& openProject(lua_State* L);  // raises if there is none

// A call as Lua sees it: counts itself, and turns exceptions into Lua errors.
using Call = int (*)(lua_State*, State&);
template <Call F>
int luaCall(lua_State* L) {
    std::string what;
    try {
        charge(L, 100);
        return F(L, stateOf(L));
    } catch (const std::exception& e) {  // Lua's own errors are no std::exception and pass
        what = e.what();
    }
    raise(L, what);
}
struct NamedCall {
    const char* name;
    lua_CFunction function;
};
// Makes the global table `name` with these functions.
void registerCalls(lua_State* L, const char* name, std::span<const NamedCall> calls);

// --- arguments ---------------------------------------------------------------------------------------------------
std::string textArg(lua_State* L, int arg);
double numberArg(lua_State* L, int arg);  // finite
// Nothing if the argument is nil or absent; raises if it is no finite number.
std::optional<double> optionalNumber(lua_State* L, int arg);
// Named options in a table argument. Each take marks its name as known; finish raises for names that nobody took.
class Options {
  public:
    Options(lua_State* L, int arg);
    double number(const char* name);  // required and finite
    // `otherwise` if it is absent; raises if it is not finite.
    double number(const char* name, double otherwise);
    std::string text(const char* name);  // required
    // `otherwise` if it is absent.
    std::string text(const char* name, const char* otherwise);
    // `otherwise` if it is absent; raises if it is no boolean.
    bool flag(const char* name, bool otherwise);
    bool push(const char* name);  // the raw value on the stack; false, and nothing pushed, if absent
    // Raises if an option is left that nobody took, naming those there are.
    void finish();

  private:
    lua_State* L_;
    int table_;
    std::vector<std::string> known_;
};
// The option {a, b, c}; raises if it is not three finite numbers of at most `most` in size.
glm::vec3 vectorOption(lua_State* L, Options& options, const char* name, const glm::vec3& otherwise, float most);
// A list of points {{x, z}, …}; raises if a coordinate is not finite.
std::vector<std::pair<double, double>> pointsArg(lua_State* L, int index, const char* what);

// --- families ----------------------------------------------------------------------------------------------------
// Each makes the global table of its family: project, entity, camera, map, mesh, bake, brush, edit, play, ui, expect.
void openProjectCalls(lua_State* L);
void openEntityCalls(lua_State* L);
void openCameraCalls(lua_State* L);
void openFilmCalls(lua_State* L);  // adds to the table camera
void openMapCalls(lua_State* L);
void openMapShapeCalls(lua_State* L);  // adds to the table map
void openMeshCalls(lua_State* L);
void openBakeCalls(lua_State* L);
void openBrushCalls(lua_State* L);
void openEditCalls(lua_State* L);
void openPlayCalls(lua_State* L);
void openUiCalls(lua_State* L);
void openExpectCalls(lua_State* L);
// The global help().
void openHelp(lua_State* L);
// What begins with a word that is being typed, "ma" or "map.me", sorted: globals, or what lies in one of them.
std::vector<std::string> completionsOf(lua_State* L, const std::string& word);

}  // namespace sward::script
