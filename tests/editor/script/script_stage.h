// A document and what runs scripts on it, for tests of scripts.
// Does not: test anything itself.
#pragma once
#include <gtest/gtest.h>

#include "script/script.h"
#include "support.h"
#include "techniques.h"

namespace sward::test {

struct ScriptStage {
    TempDir dir;
    Document doc{tables()};
    std::vector<std::string> printed;
    ScriptHost host{doc};
    ScriptStage() {
        host.print = [this](const std::string& line) { printed.push_back(line); };
    }
    Status run(const std::string& text) {
        test::writeText(dir / "test.lua", text);
        return runScript(dir / "test.lua", host);
    }
    // The error's text; "" if there is none.
    std::string fault(const std::string& text) {
        const Status s = run(text);
        return s ? "" : s.error().text();
    }
};

}  // namespace sward::test

// That a script fails, and that part of the error's text is this.
#define EXPECT_FAULT(run, script, part)                                         \
    do {                                                                        \
        const std::string fault_ = (run).fault(script);                         \
        EXPECT_NE(fault_.find(part), std::string::npos) << "fault: " << fault_; \
    } while (0)
// That a script runs to its end.
#define EXPECT_RUNS(text) EXPECT_EQ(::sward::test::ScriptStage().fault(text), "")
