#include "script/files.h"

#include <cstdlib>

namespace fs = std::filesystem;

namespace sward::script {
namespace {

// The path with every symbolic link followed, as far as it exists.
fs::path realPath(const fs::path& path) {
    std::error_code fault;
    const fs::path real = fs::weakly_canonical(fs::absolute(path), fault);
    return fault ? fs::path() : real;
}

bool isInside(const fs::path& path, const fs::path& root) {
    if (path.empty() || root.empty()) return false;
    const auto [at, of] = std::mismatch(root.begin(), root.end(), path.begin(), path.end());
    return at == root.end();
}

fs::path projectDir(State& state) {
    return state.document().isOpen() ? realPath(state.document().project().dir) : fs::path();
}

bool allowed(State& state, const fs::path& real) {
    if (isInside(real, state.folder) || isInside(real, projectDir(state))) return true;
    return std::any_of(state.tempDirs.begin(), state.tempDirs.end(),
                       [&](const fs::path& d) { return isInside(real, realPath(d)); });
}

// A link that leads nowhere would create its target when written to.
bool isDangling(const fs::path& path) {
    std::error_code fault;
    return fs::is_symlink(fs::symlink_status(path, fault)) && !fs::exists(path, fault);
}

fs::path checked(lua_State* L, const fs::path& path, const std::string& given) {
    const fs::path real = realPath(path);
    if (real.empty() || isDangling(path) || !allowed(stateOf(L), real))
        raise(L, given + ": scripts reach only files in their own folder and in the project's");
    return real;
}

fs::path firstExisting(const std::vector<fs::path>& folders, const fs::path& given) {
    std::error_code fault;
    if (given.is_absolute()) return given;
    for (const fs::path& folder : folders)
        if (!folder.empty() && fs::exists(folder / given, fault)) return folder / given;
    return folders.front() / given;
}

}  // namespace

fs::path readablePath(lua_State* L, const std::string& given) {
    State& state = stateOf(L);
    if (given.empty()) raise(L, usage("an empty name is no file", "name one"));
    return checked(L, firstExisting({state.folder, projectDir(state)}, given), given);
}

fs::path writablePath(lua_State* L, const std::string& given) {
    State& state = stateOf(L);
    if (given.empty()) raise(L, usage("an empty name is no file, and no folder", "name one"));
    const fs::path base = state.folder.empty() ? projectDir(state) : state.folder;
    return checked(L, fs::path(given).is_absolute() ? fs::path(given) : base / given, given);
}

fs::path projectPath(lua_State* L, const std::string& given) {
    State& state = stateOf(L);
    std::error_code fault;
    const fs::path found = firstExisting({state.folder, fs::current_path(fault)}, given);
    if (!fs::is_directory(found, fault))
        raise(L, unsound("there is no such project", "name a folder with a project.json").at(given));
    return realPath(found);
}

fs::path makeTempDir(lua_State* L) {
    std::string name = (fs::temp_directory_path() / "sward-script-XXXXXX").string();
    if (!mkdtemp(name.data())) raise(L, name + ": cannot make a temporary folder");
    stateOf(L).tempDirs.push_back(name);
    return name;
}

}  // namespace sward::script
