// Runs the tests of one executable, shielded from the user's settings: C locale, no shader cache, own XDG folders.
#include <gtest/gtest.h>

#include <clocale>
#include <cstdlib>

#include "tests/child.h"
#include "tests/support.h"

int main(int argc, char** argv) {
    if (const std::optional<int> code = sward::test::childMain(argc, argv)) return *code;
    sward::test::TempDir home;
    setenv("LC_ALL", "C", 1);
    setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
    setenv("XDG_CACHE_HOME", (home.path / "cache").c_str(), 1);
    setenv("XDG_STATE_HOME", (home.path / "state").c_str(), 1);
    std::setlocale(LC_ALL, "C");
    testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
