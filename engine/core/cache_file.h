// Files of the cache folder: what can be made again. One that is damaged is said, removed and made anew; one that
// cannot be written costs time, not work.
// Does not: know what is in a file, or name it.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "core/file.h"

namespace sward {

// Says why a cached file cannot be used, and removes it. what: as in "the cached slices".
void dropCached(const std::filesystem::path& file, const std::string& what, const std::string& wrong);
// Writes a file with the folders above it; failing to (a full disk, a read-only home) is logged, and otherwise ignored.
void writeCached(const std::filesystem::path& file, const std::string& what, std::string_view bytes);

// What a cached file holds; nothing if there is none. parse: bytes and a text for what is wrong with them to what they
// hold, an optional. limit: bytes.
template <class Parse>
auto loadCached(const std::filesystem::path& file, uint64_t limit, const std::string& what, Parse parse)
    -> decltype(parse(std::string(), std::declval<std::string&>())) {
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored)) return std::nullopt;
    std::string wrong;
    const Result<std::string> bytes = readFile(file, limit);
    if (bytes) {
        if (auto held = parse(*bytes, wrong)) return held;
    } else {
        wrong = bytes.error().message;
    }
    dropCached(file, what, wrong);
    return std::nullopt;
}

}  // namespace sward
