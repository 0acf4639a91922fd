#include "panels/long_frame.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "ui/theme.h"
#include "ui/widgets.h"

namespace sward {
namespace {

constexpr float kInset = 7;

float buttonWidth() { return ImGui::GetFontSize() * 8; }

}  // namespace

void takeQuicker(const LongFrameParts& p) {
    const LongFrame& f = p.frame;
    const std::string technique =
        quickerTechnique(p.doc.project(), p.doc.tables(), f.camera, f.width, f.height, f.slowest);
    if (technique.empty())
        return showError(p.messages, failed("no technique draws " + f.slowest.entity + " sooner",
                                            "lower its blades per square metre, or look from nearer"));
    if (accept(p.messages, p.doc.setField(f.slowest.entity + ".GrassField.technique", technique)))
        say(p.messages,
            fmt::format("{} is drawn by {}; undo brings {} back", f.slowest.entity, technique, f.slowest.technique));
}

void drawLongFrame(const LongFrameParts& p, const Rect& r) {
    if (!(p.frame.seconds > 0)) return;
    const std::string notice = longFrameNotice(p.frame);
    const float room = r.w - 24, buttons = 2 * buttonWidth() + 8, wrap = std::max(room - buttons - 3 * kInset, 80.f);
    const float text = ImGui::CalcTextSize(notice.c_str(), nullptr, false, wrap).y;
    const float high = std::max(text, ImGui::GetFrameHeight()) + 2 * kInset;
    ImGui::SetCursorScreenPos({r.x + 12, r.y + r.h - high - 10});
    ImGui::PushStyleColor(ImGuiCol_ChildBg, ImGui::GetStyleColorVec4(ImGuiCol_PopupBg));
    ImGui::BeginChild("long frame", {room, high});
    ImGui::SetCursorPos({kInset, kInset});
    ImGui::PushTextWrapPos(kInset + wrap);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(notice.c_str());
    ImGui::PopTextWrapPos();
    ui::record("Long frame", ui::Kind::Label, notice);
    ImGui::SetCursorPos({room - buttons - kInset, kInset});
    if (ui::button("Draw Quicker", buttonWidth(), true)) p.edits.deferred.push_back([p] { takeQuicker(p); });
    ui::tooltip("Gives the field the technique that draws this view soonest; undo brings the other back.");
    ImGui::SameLine(0, 8);
    if (ui::button(p.frame.all ? "Draw Few" : "Draw All", buttonWidth())) p.frame.all = !p.frame.all;
    ui::tooltip("All blades, however long it takes, or few of them.");
    ImGui::EndChild();
    ImGui::PopStyleColor();
}

}  // namespace sward
