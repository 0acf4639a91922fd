#include "formulas/case_source.h"

#include <sstream>
#include <vector>

#include "core/file.h"
#include "core/resources.h"

namespace sward {
namespace {

std::vector<std::string> linesOf(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

// "FN real lodRamp(real d, ...": its name, or "".
std::string nameIn(const std::string& line) {
    if (!line.starts_with("FN ")) return "";
    const size_t open = line.find('('), from = line.rfind(' ', open);
    return open == std::string::npos || from == std::string::npos ? "" : line.substr(from + 1, open - from - 1);
}

void take(const std::vector<std::string>& lines, size_t at, std::string& out) {
    size_t first = at, last = at;
    while (first > 0 && lines[first - 1].starts_with("//")) --first;
    const bool whole = lines[at].ends_with("}");  // a body on the same line
    while (!whole && last + 1 < lines.size() && lines[last] != "}") ++last;
    if (!out.empty()) out += "\n";
    for (size_t i = first; i <= last; ++i) out += lines[i] + "\n";
}

}  // namespace

std::filesystem::path caseFile(const CaseCurve& curve) { return resource("shaders") / "numerics" / curve.source; }

std::string functionText(const std::string& file, const std::string& function) {
    const std::vector<std::string> lines = linesOf(file);
    std::string out;
    for (size_t i = 0; i < lines.size(); ++i)
        if (nameIn(lines[i]) == function) take(lines, i, out);
    return out;
}

Result<std::string> caseText(const CaseCurve& curve) {
    const auto file = readFile(caseFile(curve), 1 << 20);
    if (!file) return file.error();
    std::string out = functionText(*file, curve.function);
    for (const std::string& line : linesOf(*file))
        if (const std::string name = nameIn(line); name.ends_with("Published") || name.find("Eq1") != std::string::npos)
            out += "\n" + functionText(*file, name);
    return out;
}

}  // namespace sward
