// Arguments of scripts' calls: bytes choose calls and values of all kinds, numbers beyond every range among them. A
// call ends with a result or an error, within its bounds of instructions, time and memory.
#include <array>

#include "fuzz/scratch.h"
#include "script/script.h"
#include "techniques.h"

using namespace sward;
namespace fs = std::filesystem;

namespace {

struct Bytes {
    const unsigned char* at;
    const unsigned char* end;
    unsigned next() { return at < end ? *at++ : 0u; }
    bool empty() const { return at >= end; }
};

// All calls that a console completes, "map.fill" and so on, but for those that end late by what they are.
std::vector<std::string> callNames(ScriptConsole& console) {
    std::vector<std::string> names;
    for (const std::string& table : console.completions(""))
        for (const std::string& name : console.completions(table + "."))
            if (name.find("bake.") != 0 && name.find("string.rep") != 0) names.push_back(name);
    return names;
}

constexpr std::array kNumbers = {"0",    "1",     "-1",   "0.5",   "2",     "3",     "7",          "1e9",
                                 "-1e9", "1e308", "1/0",  "-1/0",  "0/0",   "1e-30", "2147483648", "-2147483649",
                                 "64",   "128",   "1024", "16384", "16385", "0.001", "90000",      "math.mininteger"};
constexpr std::array kWords = {"''",
                               "'density'",
                               "'lawn.GrassField.species[0].density'",
                               "'lawn.GrassField.species[0].height'",
                               "'ground.Terrain.height'",
                               "'lawn'",
                               "'ground'",
                               "'sun'",
                               "'Light'",
                               "'Transform'",
                               "'camera'",
                               "'../../x'",
                               "'a.png'",
                               "'\\0'",
                               "'\\255\\254'",
                               "'[0]'",
                               "'..'",
                               "'species[1024]'",
                               "'human'",
                               "'raise'",
                               "'{}'"};

std::string value(Bytes& in, int depth);
std::string tableOf(Bytes& in, int depth) {
    std::string text = "{";
    for (unsigned n = in.next() % 4; n-- > 0;) {
        static constexpr std::array kKeys = {"x",      "z",     "radius", "strength", "value", "size",
                                             "seed",   "count", "file",   "channels", "type",  "width",
                                             "height", "from",  "to",     "within",   "name",  "opacity"};
        if (in.next() % 2) text += std::string(kKeys[in.next() % kKeys.size()]) + " = ";
        text += value(in, depth + 1) + ", ";
    }
    return text + "}";
}
std::string value(Bytes& in, int depth) {
    switch (in.next() % 8) {
        case 0:
            return "nil";
        case 1:
            return in.next() % 2 ? "true" : "false";
        case 2:
            return depth < 3 ? tableOf(in, depth) : "{}";
        case 3:
            return "function() end";
        case 4:
        case 5:
            return kWords[in.next() % kWords.size()];
        default:
            return kNumbers[in.next() % kNumbers.size()];
    }
}

// One document and console for many runs: what calls leave behind is part of the trial.
struct Editor {
    Document document{tables()};
    ScriptHost host{document};
    std::unique_ptr<ScriptConsole> console;
    std::vector<std::string> calls;
    int runs = 0;
    Editor() {
        std::error_code ignored;
        fs::remove_all(fuzz::scratch() / "work", ignored);
        fs::create_directories(fuzz::scratch() / "work");
        host.folder = fuzz::scratch() / "work";
        host.print = [](const std::string&) {};
        host.limits = {.instructions = 300'000, .seconds = 2, .memoryBytes = 32u << 20, .mapBytes = 64u << 20};
        fuzz::promise(bool(document.create(host.folder / "p")), "a new project is made");
        console = std::make_unique<ScriptConsole>(host);
        calls = callNames(*console);
        fuzz::promise(calls.size() > 50, "the console knows its calls");
    }
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, size_t size) {
    constexpr int kRunsOfOne = 200;
    static std::unique_ptr<Editor> editor;
    if (!editor || ++editor->runs > kRunsOfOne) editor = nullptr, editor = std::make_unique<Editor>();
    Bytes in{data, data + size};
    for (int n = 0; n < 6 && !in.empty(); ++n) {
        std::string line = editor->calls[(in.next() * 256u + in.next()) % editor->calls.size()] + "(";
        for (unsigned args = in.next() % 6, i = 0; i < args; ++i) line += (i ? ", " : "") + value(in, 0);
        (void)editor->console->run("pcall(function() " + line + ") end)");
    }
    return 0;
}
