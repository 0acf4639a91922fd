// Runs the tests of one executable, shielded from the user's settings: C locale, no shader cache, own XDG folders.
// What is baked (slices, traced light, volumes) is kept for all processes of this very executable, beside it; tests of
// baking itself take caches of their own.
#include <gtest/gtest.h>

#include <clocale>
#include <cstdlib>

#include "tests/child.h"
#include "tests/support.h"

namespace {
namespace fs = std::filesystem;

// A folder that goes with the executable as it was built: another build bakes anew.
fs::path bakedFolder() {
    const fs::path self = fs::read_symlink("/proc/self/exe");
    const std::string name = "baked-" + self.filename().string();
    const fs::path mine =
        self.parent_path() / (name + "-" + std::to_string(fs::last_write_time(self).time_since_epoch().count()));
    std::error_code another;  // process removes it, too
    for (const auto& entry : fs::directory_iterator(self.parent_path()))
        if (entry.path().filename().string().starts_with(name + "-") && entry.path() != mine)
            fs::remove_all(entry.path(), another);
    return mine;
}
}  // namespace

int main(int argc, char** argv) {
    if (const std::optional<int> code = sward::test::childMain(argc, argv)) return *code;
    sward::test::TempDir home;
    setenv("LC_ALL", "C", 1);
    setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
    setenv("GALLIVM_PERF", "nopt", 0);  // llvmpipe compiles faster, and draws the same pictures, by both
    setenv("LP_NATIVE_VECTOR_WIDTH", "128", 0);
    setenv("XDG_CACHE_HOME", bakedFolder().c_str(), 1);
    setenv("XDG_STATE_HOME", (home.path / "state").c_str(), 1);
    std::setlocale(LC_ALL, "C");
    testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
