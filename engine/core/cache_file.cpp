#include "core/cache_file.h"

#include "core/log.h"

namespace sward {

void dropCached(const std::filesystem::path& file, const std::string& what, const std::string& wrong) {
    logWarning(fmt::format("{}: the cached {} cannot be used: {}; made anew", file.string(), what, wrong));
    std::error_code ignored;
    std::filesystem::remove(file, ignored);
}

void writeCached(const std::filesystem::path& file, const std::string& what, std::string_view bytes) {
    std::error_code failed;
    std::filesystem::create_directories(file.parent_path(), failed);
    if (const Status s = writeFileAtomic(file, bytes); !s)
        logWarning(fmt::format("the {} is not cached: {}", what, s.error().text()));
}

}  // namespace sward
