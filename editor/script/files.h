// Which files a script may touch: those in its own folder, in the open project's, and in temporary folders it made.
// Does not: open anything. Symbolic links count as where they lead.
#pragma once
#include <filesystem>

#include "script/state.h"

namespace sward::script {

// A file to read; relative paths are looked for in the script's folder, then in the project's. Raises if it lies
// elsewhere.
std::filesystem::path readablePath(lua_State* L, const std::string& given);
// A file or folder to write; relative paths begin in the script's folder (in the console: the project's).
std::filesystem::path writablePath(lua_State* L, const std::string& given);
// An existing project to open or copy; it may lie anywhere. Relative paths are looked for in the script's folder, then
// in the current one.
std::filesystem::path projectPath(lua_State* L, const std::string& given);
// A new empty folder that is removed when the script ends.
std::filesystem::path makeTempDir(lua_State* L);

}  // namespace sward::script
