// project.*: new, open, save, saveAs, export, tempCopy, dir, name, dirty.
#include "core/hash.h"
#include "project/project_files.h"
#include "script/files.h"
#include "script/state.h"

namespace fs = std::filesystem;

namespace sward::script {
namespace {

void pushText(lua_State* L, const std::string& text) { lua_pushlstring(L, text.data(), text.size()); }

int pushList(lua_State* L, const std::vector<std::string>& items) {
    lua_createtable(L, static_cast<int>(items.size()), 0);
    for (size_t i = 0; i < items.size(); ++i) {
        pushText(L, items[i]);
        lua_rawseti(L, -2, static_cast<lua_Integer>(i) + 1);
    }
    return 1;
}

// Without a folder the project lives in a temporary one until saveAs.
int createProject(lua_State* L, State& state) {
    const bool unnamed = lua_isnoneornil(L, 1);
    const fs::path dir = unnamed ? makeTempDir(L) / "unnamed" : writablePath(L, textArg(L, 1));
    orRaise(L, state.document().create(dir));
    return 0;
}

int open(lua_State* L, State& state) {
    orRaise(L, state.document().open(projectPath(L, textArg(L, 1))));
    return 0;
}

int save(lua_State* L, State& state) {
    openProject(L);
    return pushList(L, orRaise(L, state.document().save()));
}

int saveAs(lua_State* L, State& state) {
    openProject(L);
    return pushList(L, orRaise(L, state.document().saveAs(writablePath(L, textArg(L, 1)))));
}

// project.export(file, {within = metres, camera = name}): what the .glb holds, by name.
int exportGlb(lua_State* L, State& state) {
    openProject(L);
    const fs::path file = writablePath(L, textArg(L, 1));
    double within = -1;
    std::string camera;
    if (!lua_isnoneornil(L, 2)) {
        Options options(L, 2);
        within = options.number("within", -1);
        camera = options.text("camera", "");
        options.finish();
    }
    if (!state.host.exportScene) raise(L, "project.export: this host writes no .glb");
    const auto counts = orRaise(L, state.host.exportScene(file, within, camera));
    lua_createtable(L, 0, static_cast<int>(counts.size()));
    for (const auto& [key, count] : counts) {
        lua_pushinteger(L, static_cast<lua_Integer>(count));
        lua_setfield(L, -2, key);
    }
    return 1;
}

// Links are not followed: a copy holds only what lies in the project itself.
int tempCopy(lua_State* L, State&) {
    const std::string given = textArg(L, 1);
    const fs::path from = projectPath(L, given);
    if (!fs::is_regular_file(from / "project.json"))
        raise(L, unsound("this folder is no project", "name a folder with a project.json").at(given));
    const fs::path to = makeTempDir(L) / from.filename();
    fs::copy(from, to, fs::copy_options::recursive | fs::copy_options::skip_symlinks);
    pushText(L, to.string());
    return 1;
}

int dir(lua_State* L, State&) {
    pushText(L, openProject(L).dir.string());
    return 1;
}
int name(lua_State* L, State&) {
    pushText(L, openProject(L).name);
    return 1;
}
// Reads every texel.
int hashProject(lua_State* L, State& state) {
    const Project& p = openProject(L);
    charge(L, 1'000'000);
    pushText(L, hashHex(projectHash(p, state.rows())));
    return 1;
}
int dirty(lua_State* L, State& state) {
    lua_pushboolean(L, state.document().dirty());
    return 1;
}

}  // namespace

void openProjectCalls(lua_State* L) {
    constexpr NamedCall calls[] = {{"new", luaCall<createProject>}, {"open", luaCall<open>},
                                   {"save", luaCall<save>},         {"saveAs", luaCall<saveAs>},
                                   {"export", luaCall<exportGlb>},  {"tempCopy", luaCall<tempCopy>},
                                   {"dir", luaCall<dir>},           {"name", luaCall<name>},
                                   {"dirty", luaCall<dirty>},       {"hash", luaCall<hashProject>}};
    registerCalls(L, "project", calls);
}

}  // namespace sward::script
