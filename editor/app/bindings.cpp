#include "app/bindings.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "app/commands.h"
#include "app/layout.h"
#include "core/log.h"

namespace sward {
namespace {

std::optional<Chord> chordIn(const std::string& text) { return text.empty() ? std::nullopt : parseChord(text); }

const Command* ownerOf(const Bindings& bindings, const Chord& chord, const Command* but) {
    for (const Command& c : commands())
        if (&c != but && runsBy(bindings, c, chord)) return &c;
    return nullptr;
}

Status mayHave(const Bindings& bindings, const Command& command, const std::string& chord) {
    const std::optional<Chord> keys = chordIn(chord);
    if (!keys) return failed(fmt::format("'{}' names no keys", chord), "such as ctrl+s, shift+h, f5 or [");
    if (const Command* other = ownerOf(bindings, *keys, &command))
        return failed(fmt::format("{} runs {} already", chordText(chord), commandName(*other)),
                      "take other keys, or give that command others first");
    return {};
}

const Command* commandNamed(const std::string& name) {
    const auto all = commands();
    const auto it = std::find_if(all.begin(), all.end(), [&](const Command& c) { return commandName(c) == name; });
    return it == all.end() ? nullptr : &*it;
}

void readLine(const std::string& line, Bindings& bindings, const std::string& place) {
    const size_t sign = line.find(" =");
    const Command* command = sign == std::string::npos ? nullptr : commandNamed(line.substr(0, sign));
    if (!command)
        return logWarning(fmt::format("{}: no command is called '{}'; left out", place, line.substr(0, sign)));
    const size_t from = line.find_first_not_of(' ', sign + 2);
    const Status bound = bindKey(bindings, *command, from == std::string::npos ? "" : line.substr(from));
    if (!bound) logWarning(fmt::format("{}: {}", place, bound.error().text()));
}

}  // namespace

void openKeys(KeysDialog& dialog) { dialog = {true, true, "", "", ""}; }

std::string commandName(const Command& c) { return fmt::format("{}/{}", c.menu, c.label); }

std::string chordOf(const Bindings& bindings, const Command& c) {
    const auto it = bindings.own.find(commandName(c));
    return it == bindings.own.end() ? c.chord : it->second;
}

bool runsBy(const Bindings& bindings, const Command& c, const Chord& pressed) {
    if (chordIn(chordOf(bindings, c)) == pressed) return true;
    return !bindings.own.contains(commandName(c)) && chordIn(c.chord2) == pressed;
}

Status bindKey(Bindings& bindings, const Command& c, const std::string& chord) {
    if (!chord.empty())
        if (Status s = mayHave(bindings, c, chord); !s) return s;
    bindings.own[commandName(c)] = chord;
    return {};
}

Status unbindKey(Bindings& bindings, const Command& c) {
    for (const std::string chord : {c.chord, c.chord2})
        if (!chord.empty())
            if (Status s = mayHave(bindings, c, chord); !s) return s;
    bindings.own.erase(commandName(c));
    return {};
}

std::optional<std::filesystem::path> bindingsFile() {
    const auto layout = layoutFile();
    return layout ? std::optional(layout->parent_path() / "keys.txt") : std::nullopt;
}

Bindings loadBindings(const std::filesystem::path& file) {
    Bindings bindings;
    std::ifstream in(file);
    std::string line;
    for (int n = 1; std::getline(in, line); ++n)
        if (!line.empty()) readLine(line, bindings, fmt::format("{}:{}", file.string(), n));
    return bindings;
}

bool saveBindings(const std::filesystem::path& file, const Bindings& bindings) {
    std::error_code error;
    std::filesystem::create_directories(file.parent_path(), error);
    std::ofstream out(file);
    for (const auto& [command, chord] : bindings.own) out << command << " = " << chord << '\n';
    return static_cast<bool>(out.flush());
}

}  // namespace sward
