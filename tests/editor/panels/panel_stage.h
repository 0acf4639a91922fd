// Panels without an editor, a renderer or OpenGL: Dear ImGui builds frames that nobody draws, and the pointer clicks
// what a panel wrote down of its widgets. A panel takes only its parts, so a test gives it those and no more.
// Does not: test anything itself.
#pragma once
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <gtest/gtest.h>
#include <imgui.h>

#include <functional>
#include <string>

#include "app/edits.h"
#include "app/messages.h"
#include "app/waiting.h"
#include "model/document.h"
#include "panels/field_edit.h"
#include "support.h"
#include "techniques.h"
#include "ui/imgui_compat.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace sward::test {

// Each test gets an ImGui context and a new project of its own.
class PanelStage : public testing::Test {
  protected:
    PanelStage() : context_(ImGui::CreateContext()) {
        ImGui::SetCurrentContext(context_);
        ui::setUpContext();
        ui::applyTheme(1);
        ImGui::GetIO().Fonts->Build();
    }
    ~PanelStage() override { ImGui::DestroyContext(context_); }
    void SetUp() override {
        ASSERT_TRUE(doc.create(dir / "meadow"));
        frames(4);  // a modal before the other windows are there stops ImGui
    }

    // Frames in which `draw` is called within a window, its widgets under `name`; edits run after each, as in the
    // editor.
    void frames(int count = 1) {
        for (int i = 0; i < count; ++i) {
            in = queue.next();
            ui::feedInput(in, 1.0f / 60, 800, 600, 800, 600);
            ImGui::NewFrame();
            ui::beginBook(book);
            {
                const ui::Scope scope(name);
                ImGui::SetNextWindowPos({0, 30});
                ImGui::SetNextWindowSize({800, 570});
                ImGui::Begin("stage", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
                draw();
                ImGui::End();
            }
            ui::endBook(book);
            runDeferred(edits);
            releaseGroup(edits, doc, ImGui::IsAnyItemActive());
            ImGui::Render();
        }
    }
    bool shown(const std::string& path) { return book.widgets.contains(path); }
    std::string value(const std::string& path) { return shown(path) ? book.widgets.at(path).value : "not there"; }
    void click(const std::string& path) {
        frames(2);
        ASSERT_TRUE(shown(path)) << path;
        const ui::Widget w = book.widgets.at(path);
        queue.push(
            {InputKind::Move, static_cast<double>(w.x0 + w.x1) / 2, static_cast<double>(w.y0 + w.y1) / 2, 0, false});
        frames(2);
        queue.push({InputKind::Button, 0, 0, 0, true});
        frames();
        queue.push({InputKind::Button, 0, 0, 0, false});
        frames(2);
        ui::forgetClicks();
    }
    // Into the text line at `path`, with Enter.
    void type(const std::string& path, const std::string& text) {
        click(path);
        for (const char c : text) queue.push({InputKind::Char, 0, 0, c, false});
        frames(2);
        queue.push({InputKind::Key, 0, 0, GLFW_KEY_ENTER, true});
        queue.push({InputKind::Key, 0, 0, GLFW_KEY_ENTER, false});
        frames(4);
    }
    FieldParts fieldParts() { return {doc, edits, book.errors, messages}; }
    std::string field(const std::string& path) {
        const auto f = findField(doc.project(), doc.tables().components, path);
        return f ? fieldText(*f) : "error: " + f.error().text();
    }

    TempDir dir;
    Document doc{tables()};
    Edits edits;
    Messages messages;
    Waiting waiting;
    InputQueue queue;
    FrameInput in;
    ui::WidgetBook book;
    std::string name = "Panel";
    std::function<void()> draw = [] {};

  private:
    ImGuiContext* context_;
};

}  // namespace sward::test
