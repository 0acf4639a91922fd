// The project's own sources as text, for tests of what style asks of them.
#pragma once
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <string>
#include <vector>

namespace sward::test {

using Lines = std::vector<std::string>;

inline Lines linesOf(const std::filesystem::path& file) {
    std::ifstream in(file);
    Lines lines;
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

// Headers and sources under these folders of root, relative to it, sorted. A folder that is not there has none.
inline std::vector<std::filesystem::path> sources(const std::filesystem::path& root,
                                                  std::initializer_list<const char*> folders) {
    std::vector<std::filesystem::path> out;
    for (const char* folder : folders) {
        if (!std::filesystem::is_directory(root / folder)) continue;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(root / folder))
            if (const std::filesystem::path ext = entry.path().extension(); ext == ".h" || ext == ".cpp")
                out.push_back(entry.path().lexically_relative(root));
    }
    std::sort(out.begin(), out.end());
    return out;
}

// One a line, each on a line of its own and indented.
inline std::string joined(const Lines& lines) {
    std::string out;
    for (const std::string& line : lines) out += "\n  " + line;
    return out;
}

}  // namespace sward::test
