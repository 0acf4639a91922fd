// A script in a folder of its own within another, for tests of what it cannot reach.
// Does not: test anything itself.
#pragma once
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "script/script.h"
#include "support.h"
#include "techniques.h"

namespace sward::test {

struct Cage {
    TempDir dir;
    Document doc{tables()};
    ScriptHost host{doc};
    Status run(const std::string& text) {
        test::writeText(dir / "inside/test.lua", text);
        return runScript(dir / "inside/test.lua", host);
    }
    std::string fault(const std::string& text) {
        const Status s = run(text);
        return s ? "" : s.error().text();
    }
};
// Whether an error says this.
inline bool says(const std::string& fault, const std::string& part) { return fault.find(part) != std::string::npos; }

}  // namespace sward::test
