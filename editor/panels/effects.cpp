// Which effects the view that is shown does not show: each one's share of changed pixels, what it costs, a click that
// turns it off, and beside it where it changes pixels.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "app/edits.h"
#include "app/effect_run.h"
#include "app/frame_clock.h"
#include "model/document.h"
#include "panels/panels.h"
#include "panels/picture_strip.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace sward {
namespace {

std::string stateText(const EffectRun& run, const Document& doc) {
    if (!run.error.empty()) return run.error;
    if (run.effects.empty()) return "What each effect of the scene changes in this view, and what it costs.";
    const std::string of = fmt::format("{} at {} x {}", run.camera, run.size.x, run.size.y);
    return run.revision == doc.revision() ? of : of + "; the project has changed since";
}

void controls(const EffectParts& p) {
    EffectRun& run = p.run;
    if (run.running()) {
        if (ui::button("Stop")) stopRun(run);
        ImGui::SameLine(0, 8);
        const std::string news = newsText(run.news, p.measure.clock.now);
        ui::coloredText(ui::kDimText, news.c_str());
        ui::record("Measuring", ui::Kind::Label, news);
        return;
    }
    if (ui::button("Measure"))
        p.edits.deferred.push_back([&run, measure = p.measure, size = p.size, seconds = p.seconds] {
            startEffects(run, measure, size, seconds);
        });
    ui::tooltip(
        "Draws this view with and without each effect that the scene asks for. Takes some minutes, beside the editor;\n"
        "the project is copied as it is now, unsaved work included.");
    ImGui::SameLine(0, 8);
    const std::string text = stateText(run, p.measure.doc);
    ui::coloredText(run.error.empty() ? ui::kDimText : ui::kErrorText, text.c_str());
    ui::record("State", ui::Kind::Label, text);
}

std::string spoken(Feature f) {
    std::string name = featureName(f);
    std::replace(name.begin(), name.end(), '-', ' ');
    return name;
}

// What turns it off, each on a line of its own.
std::string stepsOf(const EffectLine& e) {
    std::string text;
    for (const std::string& step : e.off) text += "\n" + step;
    return text;
}

void cell(const char* label, const std::string& text, bool marked, const std::string& help) {
    ImGui::TableNextColumn();
    ImGui::AlignTextToFramePadding();
    if (marked)
        ui::coloredText(ui::kWarningText, text.c_str());
    else
        ImGui::TextUnformatted(text.c_str());
    ui::record(label, ui::Kind::Label, text);
    ui::tooltip(help);
}

void offButton(const EffectParts& p, const EffectLine& e) {
    ImGui::TableNextColumn();
    ImGui::AlignTextToFramePadding();
    if (!has(p.run.present, e.feature)) return ui::coloredText(ui::kDimText, "is off");
    if (ui::button("Turn Off", 0, e.costsUnseen))
        p.edits.deferred.push_back([doc = &p.measure.doc, messages = &p.measure.messages, feature = e.feature] {
            turnOffNow(*doc, *messages, feature);
        });
    ui::tooltip("One undo step:" + stepsOf(e));
}

void effectRow(const EffectParts& p, const EffectLine& e) {
    const ui::Scope scope(featureName(e.feature));
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::AlignTextToFramePadding();
    if (ui::selectable(spoken(e.feature), p.run.shown == e.feature)) showEffect(p.run, e.feature);
    ui::tooltip(std::string(featureRow(e.feature).help) + "; off by:" + stepsOf(e));
    if (!e.error.empty()) {
        cell("Error", "not measured", false, e.error);
        ImGui::TableNextColumn();
        return offButton(p, e);
    }
    cell("Changes", shareText(e.changed, e.share), e.costsUnseen,
         e.changed == 0 ? "No pixel of this view changes without it."
                        : fmt::format("{} pixels change without it, the most by {} of 255.", e.changed, e.greatest));
    cell("Cost", differenceText(e.ms), e.costsUnseen,
         fmt::format("What a frame takes less without it: the median of {} pairs of frames, and between what it lies "
                     "with {:.0f} %.",
                     e.ms.pairs, 100 * e.ms.confidence));
    offButton(p, e);
}

void list(const EffectParts& p) {
    if (!ImGui::BeginTable("effects", 4, ImGuiTableFlags_SizingStretchProp)) return;
    ImGui::TableSetupColumn("Effect", 0, 1.1f);
    ImGui::TableSetupColumn("Changes", 0, 0.7f);
    ImGui::TableSetupColumn("Costs", 0, 1.4f);
    ImGui::TableSetupColumn("", 0, 0.7f);
    ImGui::TableHeadersRow();
    for (const EffectLine& e : p.run.effects) effectRow(p, e);
    ImGui::EndTable();
}

}  // namespace

void drawEffects(const EffectParts& p) {
    if (!p.measure.doc.isOpen()) return ImGui::TextDisabled("No project is open.");
    controls(p);
    const bool picture = p.run.picture.id() != 0;
    ImGui::BeginChild("list", {picture ? ImGui::GetContentRegionAvail().x * 0.62f : 0.f, 0});
    if (!p.run.effects.empty()) list(p);
    ImGui::EndChild();
    if (!picture) return;
    ImGui::SameLine();
    ImGui::BeginChild("where");
    drawStrip({{"where it changes the picture", &p.run.picture}});
    ImGui::EndChild();
}

}  // namespace sward
