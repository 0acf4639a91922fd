#include "ui/words.h"

#include <cctype>
#include <map>
#include <string_view>
#include <utility>

namespace sward::ui {
namespace {

bool inName(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '-'; }
bool isUpper(char c) { return std::isupper(static_cast<unsigned char>(c)); }

size_t afterName(const std::string& text, size_t at) {
    while (at < text.size() && inName(text[at])) ++at;
    return at;
}

// Where the PATH that begins here ends; `at` itself if none does.
size_t afterPath(const std::string& text, size_t at) {
    size_t end = afterName(text, at);
    if (end == at || end + 1 >= text.size() || text[end] != '.' || !isUpper(text[end + 1])) return at;
    end = afterName(text, end + 1);
    int fields = 0;
    while (end + 1 < text.size()) {
        if (text[end] == '.' && std::islower(static_cast<unsigned char>(text[end + 1]))) {
            end = afterName(text, end + 1), ++fields;
        } else if (text[end] == '[' && fields > 0 && text.find(']', end) != std::string::npos) {
            end = text.find(']', end) + 1;
        } else {
            break;
        }
    }
    return fields > 0 ? end : at;
}

// "ambientOcclusion" as "ambient occlusion".
std::string words(const std::string& name) {
    std::string out;
    for (const char c : spelt(name)) {
        if (isUpper(c)) out += ' ';
        out += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    return out;
}

std::string capitalized(std::string text) {
    if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
    return text;
}

std::string pathInWords(const std::string& path) {
    const size_t open = path.rfind('['), close = path.find(']', open == std::string::npos ? 0 : open);
    const bool element = open != std::string::npos;
    const std::string inside = element ? path.substr(open + 1, close - open - 1) : "";
    const bool numbered = inside.find_first_not_of("0123456789") == std::string::npos;
    const size_t field = path.find('.', element ? close : path.find('.') + 1);
    const std::string of = numbered ? path.substr(0, path.find('.')) : inside;
    if (field == std::string::npos) return capitalized(of);  // the element itself
    const size_t last = path.rfind('.');
    return capitalized(of) + " \xE2\x80\xBA " + words(path.substr(std::max(field, last) + 1));
}

}  // namespace

std::string spelt(std::string name) {
    for (const auto& [written, read] : {std::pair{"olor", "olour"}, std::pair{"enter", "entre"}})
        for (size_t at = 0; (at = name.find(written, at)) != std::string::npos; at += 5)
            name.replace(at, std::string_view(written).size(), read);
    return name;
}

std::string inWords(const std::string& text) {
    std::string out;
    for (size_t at = 0; at < text.size();) {
        const bool begins = at == 0 || !(inName(text[at - 1]) || text[at - 1] == '.' || text[at - 1] == '/');
        const size_t end = begins ? afterPath(text, at) : at;
        if (end > at) {
            out += pathInWords(text.substr(at, end - at));
            at = end;
        } else {
            out += text[at++];
        }
    }
    return out;
}

std::vector<std::string> inWordsApart(std::span<const std::string> texts) {
    std::map<std::string, int> uses;
    for (const std::string& text : texts) ++uses[inWords(text)];
    std::vector<std::string> out;
    for (const std::string& text : texts) {
        out.push_back(inWords(text));
        if (uses[out.back()] > 1 && out.back() != text) out.back() += " (" + text.substr(0, text.find('.')) + ")";
    }
    return out;
}

}  // namespace sward::ui
