// What fuzz targets share: a folder of their own, in memory where there is one, and the end of a run whose promise was
// broken. A target is one file NAME_fuzz.cpp that defines LLVMFuzzerTestOneInput; its seeds are made by seeds.cpp.
// Does not: fuzz anything itself.
#pragma once
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>

#include "tests/support.h"

namespace sward::fuzz {

// Lives until the process ends. Many readers write beside what they read, so each process has its own.
inline const std::filesystem::path& scratch() {
    static const test::TempDir dir;
    return dir.path;
}

// Writes one input to a file of this name in the scratch folder.
inline std::filesystem::path inputFile(const std::string& name, std::string_view bytes) {
    const std::filesystem::path file = scratch() / name;
    test::writeText(file, std::string(bytes));
    return file;
}

// Ends the run if a reader's promise does not hold; libFuzzer keeps the input.
inline void promise(bool holds, const char* what) {
    if (holds) return;
    std::fprintf(stderr, "broken promise: %s\n", what);
    std::abort();
}

inline std::string_view textOf(const unsigned char* data, size_t size) {
    return {reinterpret_cast<const char*>(data), size};
}

}  // namespace sward::fuzz
