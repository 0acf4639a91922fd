// Running a file, and a console's lines.
#include "script/script.h"

#include <fstream>

#include "script/state.h"

namespace fs = std::filesystem;

namespace sward {
namespace {

using namespace script;

constexpr size_t kMostScriptBytes = size_t(16) << 20;

Error noMemory() { return failed("there is no memory for a script"); }

Result<std::string> readScript(const fs::path& file) {
    std::error_code fault;
    if (!fs::exists(file, fault)) return usage("there is no such script", "name a Lua file").at(file);
    if (const Status s = checkRegular(file); !s) return usage(s.error().message, "name a Lua file").at(file);
    if (fs::file_size(file, fault) > kMostScriptBytes) return unsound("a script of more than 16 MiB").at(file);
    std::ifstream in(file, std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(in), {}};
    if (!in) return unsound("the script cannot be read", "look at its permissions").at(file);
    if (text.starts_with(LUA_SIGNATURE[0]))
        return unsound("this is compiled Lua; scripts are text only", "run the source").at(file);
    return text;
}

// What errors call the chunk: the file's name, short enough that Lua does not cut it.
std::string tokenOf(const fs::path& file) {
    const std::string name = file.filename().string();
    return name.size() <= 40 ? name : name.substr(0, 40);
}

// Loads text as a chunk; on failure the error message is on the stack.
bool load(lua_State* L, const std::string& text, const std::string& token) {
    return luaL_loadbufferx(L, text.data(), text.size(), ("=" + token).c_str(), "t") == LUA_OK;
}

Error syntaxError(lua_State* L, const std::string& token, const fs::path& file) {
    std::string message = lua_tostring(L, -1);
    Error error = failed(message).at(file);
    if (!message.starts_with(token + ":")) return error;
    char* end = nullptr;
    error.line = static_cast<int>(std::strtol(message.c_str() + token.size() + 1, &end, 10));
    error.message = std::string(*end == ':' ? end + 2 : end);
    return error;
}

}  // namespace

Status runScript(const fs::path& file, ScriptHost& host) {
    const Result<std::string> text = readScript(file);
    if (!text) return text.error();
    State state(host);
    std::error_code fault;
    state.folder = fs::weakly_canonical(fs::absolute(file), fault).parent_path();
    const LuaPtr L = openLua(state);
    if (!L) return noMemory();
    const std::string token = tokenOf(file);
    if (!load(L.get(), *text, token)) return syntaxError(L.get(), token, file);
    return runChunk(L.get(), 0, token, file);
}

struct ScriptConsole::Impl {
    State state;
    LuaPtr L;
    explicit Impl(ScriptHost& host) : state(host), L(openLua(state)) {}
};

ScriptConsole::ScriptConsole(ScriptHost& host) : impl_(std::make_unique<Impl>(host)) {}
ScriptConsole::~ScriptConsole() = default;

std::vector<std::string> ScriptConsole::completions(const std::string& word) {
    lua_State* L = impl_->L.get();
    return L ? completionsOf(L, word) : std::vector<std::string>{};
}

Status ScriptConsole::run(const std::string& line) {
    lua_State* L = impl_->L.get();
    if (!L) return noMemory();
    std::error_code fault;
    State& state = impl_->state;
    state.folder =
        state.host.folder.empty() ? fs::path() : fs::weakly_canonical(fs::absolute(state.host.folder), fault);
    const std::string token = "console";
    lua_settop(L, 0);
    if (!load(L, "return " + line, token)) {  // a statement, not an expression
        lua_settop(L, 0);
        if (!load(L, line, token)) return syntaxError(L, token, "console");
    }
    if (Status done = runChunk(L, 0, token, "console"); !done) return done;
    if (lua_gettop(L) == 0) return {};
    lua_getglobal(L, "print");
    lua_insert(L, 1);
    return runChunk(L, lua_gettop(L) - 1, token, "console");
}

}  // namespace sward
