#include "core/resources.h"

namespace sward {
namespace fs = std::filesystem;

fs::path resourceOf(const fs::path& program, const fs::path& source, const std::string& name) {
    const fs::path folder = program.parent_path();
    std::error_code error;
    for (const fs::path& root : {folder / ".." / "share" / "sward", folder / ".." / ".."})
        if (!program.empty() && fs::exists(root / name, error)) return fs::weakly_canonical(root / name, error);
    return source / name;
}

fs::path resource(const std::string& name) {
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    return resourceOf(error ? fs::path() : program, SWARD_SOURCE_DIR, name);
}

}  // namespace sward
