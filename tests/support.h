// What many tests need: a temporary folder, small files.
#pragma once
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>

extern "C" __attribute__((weak)) void __asan_init();

namespace sward::test {

// Whether this executable holds the address sanitizer.
inline bool sanitized() { return &__asan_init != nullptr; }

// A new empty folder, removed with all it holds when this goes.
struct TempDir {
    std::filesystem::path path;
    TempDir() {
        std::string name = (std::filesystem::temp_directory_path() / "sward-test-XXXXXX").string();
        if (!mkdtemp(name.data()))
            throw std::filesystem::filesystem_error("mkdtemp", name, std::error_code(errno, std::generic_category()));
        path = name;
    }
    ~TempDir() {
        std::error_code ignored;
        std::filesystem::remove_all(path, ignored);
    }
    TempDir(const TempDir&) = delete;
    TempDir& operator=(const TempDir&) = delete;
    std::filesystem::path operator/(const std::string& name) const { return path / name; }
};

// While it lives nothing is baked yet, and what is baked goes with it.
class EmptyCache {
  public:
    EmptyCache() {
        if (const char* was = std::getenv("XDG_CACHE_HOME")) before_ = was;
        setenv("XDG_CACHE_HOME", folder_.path.c_str(), 1);
    }
    ~EmptyCache() {
        if (before_)
            setenv("XDG_CACHE_HOME", before_->c_str(), 1);
        else
            unsetenv("XDG_CACHE_HOME");
    }

    // Of this and other programs: cacheDir() lies in it.
    const std::filesystem::path& path() const { return folder_.path; }

  private:
    TempDir folder_;
    std::optional<std::string> before_;
};

// Makes the folders on the way.
inline void writeText(const std::filesystem::path& file, const std::string& text) {
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << text;
}
// Empty if there is no such file.
inline std::string readText(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace sward::test
