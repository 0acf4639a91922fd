#include "app/palette.h"

#include <algorithm>
#include <cctype>
#include <optional>

#include "app/commands.h"

namespace sward {
namespace {

constexpr int kLetter = 1, kFollows = 6, kWordBegins = 8;

bool sameLetter(char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
}
bool wordBegins(const std::string& text, size_t at) {
    return at == 0 || !std::isalnum(static_cast<unsigned char>(text[at - 1]));
}

// The most that the letters from one on are worth, by the place of that one: where it follows on the letter before it
// in the text, and where it does not. 0: there is no place for them.
struct Worth {
    std::vector<int> following, apart;
};

Worth worthOf(char letter, const std::string& text, const Worth* rest) {
    Worth w{std::vector<int>(text.size() + 1), std::vector<int>(text.size() + 1)};
    int later = 0;  // of the rest, beyond the next letter of the text
    for (size_t at = text.size(); at-- > 0;) {
        const int then = rest ? std::max(rest->following[at + 1], later) : kLetter;
        if (then > 0 && sameLetter(text[at], letter)) {
            const bool word = wordBegins(text, at);
            w.following[at] = then + (word ? kWordBegins : kFollows);
            w.apart[at] = then + (word ? kWordBegins : kLetter);
        }
        if (rest) later = std::max(later, rest->apart[at + 1]);
    }
    return w;
}

}  // namespace

void openPalette(Palette& palette) { palette = {true, true, "", 0}; }

int paletteMatch(const std::string& typed, const std::string& text) {
    std::optional<Worth> worth;
    for (size_t i = typed.size(); i-- > 0;)
        if (typed[i] != ' ') worth = worthOf(typed[i], text, worth ? &*worth : nullptr);
    return worth ? *std::max_element(worth->apart.begin(), worth->apart.end()) : kLetter;
}

std::vector<PaletteLine> paletteLines(const std::string& typed, std::span<const CommandState> states,
                                      const std::vector<std::string>& entities) {
    std::vector<std::pair<int, PaletteLine>> found;
    const auto look = [&](PaletteLine line) {
        if (const int match = paletteMatch(typed, line.label)) found.emplace_back(match, std::move(line));
    };
    for (const CommandState& s : states)
        if (s.enabled) look({&s, std::string(s.command->menu) + " \xE2\x80\xBA " + s.command->label});
    for (const std::string& entity : entities) look({nullptr, entity});
    std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    std::vector<PaletteLine> lines;
    for (auto& [match, line] : found) lines.push_back(std::move(line));
    return lines;
}

}  // namespace sward
