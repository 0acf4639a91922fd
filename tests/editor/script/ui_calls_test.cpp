// ui.* of docs/scripting.md, as far as scripts see the interface.
#include <fmt/format.h>

#include "editor/script/script_stage.h"

namespace sward {
namespace {

using test::ScriptStage;

struct RecordingUi : UiDriver {
    std::vector<std::string> calls;
    Status click(const std::string& label) override { return note("click " + label); }
    Status rightClick(const std::string& label) override { return note("right click " + label); }
    Status drop(const std::filesystem::path& file) override { return note("drop " + file.filename().string()); }
    Status set(const std::string& label, const std::string& text) override { return note("set " + label + " " + text); }
    Result<std::string> get(const std::string& label) override {
        if (label == "Brush/Radius") return std::string("2.5");
        return failed("no widget " + label);
    }
    bool exists(const std::string& label) override { return label == "Brush/Radius"; }
    Status key(const std::string& chord) override { return note("key " + chord); }
    Result<std::array<double, 4>> rect(const std::string& label) override {
        if (label == "Brush/Radius") return std::array<double, 4>{10, 20, 30.5, 40};
        return failed("no widget " + label);
    }
    Status drag(double x1, double y1, double x2, double y2, const std::string& held) override {
        return note(fmt::format("drag {} {} {} {}{}{}", x1, y1, x2, y2, held.empty() ? "" : " ", held));
    }
    Status wait(int frames) override { return note(fmt::format("wait {}", frames)); }
    Status screenshot(const std::filesystem::path& file) override {
        return note("screenshot " + file.filename().string());
    }
    Status note(const std::string& call) {
        calls.push_back(call);
        return {};
    }
};

TEST(UiCalls, UiCallsReachTheDriver) {
    ScriptStage r;
    RecordingUi ui;
    r.host.ui = &ui;
    EXPECT_EQ(r.fault(R"(
        ui.click('Menu/File/Save') ui.set('Brush/Radius', 3) ui.set('Brush/Mode', 'add') ui.key('ctrl+z')
        ui.rightClick('Outliner/bench') ui.drop('test.lua')
        ui.drag(1, 2, 3.5, 4) ui.drag(1, 2, 3, 4, 'ctrl+shift') ui.wait(5) ui.wait() ui.screenshot('shot.png')
        expect.equal(ui.get('Brush/Radius'), '2.5')
        expect.equal({ui.rect('Brush/Radius')}, {10, 20, 30.5, 40})
        expect.truthy(ui.exists('Brush/Radius')) expect.truthy(not ui.exists('Brush/Smell')))"),
              "");
    EXPECT_EQ(ui.calls,
              (std::vector<std::string>{"click Menu/File/Save", "set Brush/Radius 3", "set Brush/Mode add",
                                        "key ctrl+z", "right click Outliner/bench", "drop test.lua", "drag 1 2 3.5 4",
                                        "drag 1 2 3 4 ctrl+shift", "wait 5", "wait 1", "screenshot shot.png"}));
    EXPECT_FAULT(r, "ui.get('Brush/Smell')", "no widget Brush/Smell");
    EXPECT_FAULT(r, "ui.rect('Brush/Smell')", "no widget Brush/Smell");
    EXPECT_FAULT(r, "ui.wait(1e9)", "frames");
    EXPECT_FAULT(r, "ui.screenshot('/shot.png')", "scripts reach only files");
}

TEST(UiCalls, UiCallsWithoutAWindowSaySo) {
    for (const char* call :
         {"ui.click('x')", "ui.set('x', 1)", "ui.get('x')", "ui.exists('x')", "ui.key('a')", "ui.drag(1, 2, 3, 4)",
          "ui.rect('x')", "ui.wait(1)", "ui.screenshot('x.png')", "ui.rightClick('x')", "ui.drop('test.lua')"})
        EXPECT_FAULT(ScriptStage(), call, "test.lua:1: ui.* needs the editor's window");
}

}  // namespace
}  // namespace sward
