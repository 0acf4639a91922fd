#include "panels/transitions.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "cost/transition_plot.h"
#include "model/document.h"
#include "model/film_plan.h"
#include "ui/plot_view.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace sward {
namespace {

// The path that is asked for, of those there are.
void choosePath(TransitionPlan& plan, const std::vector<std::string>& paths) {
    auto chosen = std::find(paths.begin(), paths.end(), plan.path);
    if (chosen == paths.end()) chosen = paths.begin(), plan.path = *chosen;
    int index = static_cast<int>(chosen - paths.begin());
    ui::coloredText(ui::kDimText, "Path");
    ImGui::SameLine(0, 5);
    ImGui::SetNextItemWidth(ImGui::GetFontSize() * 8);
    if (ui::combo("Path", paths, index)) plan.path = paths[static_cast<size_t>(index)];
}

void choosePictures(TransitionPlan& plan) {
    ImGui::SameLine(0, 10);
    ui::coloredText(ui::kDimText, "Pictures");
    ImGui::SameLine(0, 5);
    ImGui::SetNextItemWidth(ImGui::GetFontSize() * 5);
    const ui::NumberSpec spec{
        .softMin = 5, .softMax = 100, .hardMin = 2, .hardMax = kMostTransitionPictures, .unit = "", .integer = true};
    auto pictures = static_cast<float>(plan.pictures);
    if (ui::slider("Pictures", pictures, spec)) plan.pictures = static_cast<int>(pictures);
    ui::tooltip(
        "How many moments of the path are compared, evenly from its beginning to its end.\nMore find shorter "
        "transitions and take longer.");
}

// From one second of the path to another; 0: to its end.
void walk(const TransitionParts& p, double from, double to) {
    p.meter.plan.from = from, p.meter.plan.to = to;
    p.edits.deferred.push_back([meter = &p.meter, doc = &p.doc] { startTransitions(*meter, *doc); });
}

void controls(const TransitionParts& p, const std::vector<std::string>& paths) {
    TransitionMeter& m = p.meter;
    ImGui::AlignTextToFramePadding();
    {
        const ui::Disabled runs(walking(m));
        choosePath(m.plan, paths);
        choosePictures(m.plan);
    }
    ImGui::SameLine(0, 10);
    if (walking(m)) {
        if (ui::button("Stop")) stopTransitions(m);
        ImGui::SameLine(0, 8);
        ImGui::PushStyleColor(ImGuiCol_PlotHistogram, ui::kFill);
        ImGui::ProgressBar(static_cast<float>(shareOf(m)), {ImGui::GetFontSize() * 14, 0}, newsOf(m).c_str());
        ImGui::PopStyleColor();
        ui::record("Walking", ui::Kind::Label, newsOf(m));
        return;
    }
    if (ui::button("Walk")) walk(p, 0, 0);
    ui::tooltip(
        "Draws the project from each of these moments and ray-traces the same: what changes from one to the next "
        "and not in the truth pops.\nTime stands still meanwhile. Goes on beside your work.");
}

void goTo(const TransitionParts& p, int step) {
    if (step < 0) return;
    p.meter.shown = step;
    p.view.camera = flyFrom(p.meter.result->views[static_cast<size_t>(step)]);
    p.view.pathSecond = static_cast<float>(p.meter.result->seconds[static_cast<size_t>(step)]);
}

std::string summaryOf(const Transitions& t) {
    return fmt::format(
        "{} of {} steps pop more than other blades do. In the mean {:.4f}, other blades {:.4f}; at worst "
        "{:.4f}.",
        stepsAboveFloor(t), t.drawn.steps.size(), t.drawn.mean, t.floor.mean, t.drawn.worst);
}

// What can be done with the step that the view was taken to.
void shownStep(const TransitionParts& p, const Transitions& t) {
    const auto i = static_cast<size_t>(p.meter.shown);
    if (ui::button("Next moment")) p.view.camera = flyFrom(t.views[i + 1]);
    ui::tooltip("Takes the view to where that step ends: what pops is between the two.");
    ImGui::SameLine(0, 8);
    {
        const ui::Disabled runs(walking(p.meter));
        if (ui::button("Walk this step")) walk(p, t.seconds[i], t.seconds[i + 1]);
    }
    ui::tooltip("Walks that step alone, by as many pictures: short steps tell a transition from blades that move by.");
    ImGui::SameLine(0, 8);
}

void summary(const TransitionParts& p, const Transitions& t) {
    if (ui::button("Go to worst")) goTo(p, t.drawn.worstStep);
    ui::tooltip("Takes the view to where the step begins that pops most.");
    ImGui::SameLine(0, 8);
    if (p.meter.shown >= 0) shownStep(p, t);
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(summaryOf(t).c_str());
    ui::record("Summary", ui::Kind::Label, summaryOf(t));
    if (p.meter.revision != p.doc.revision()) ui::coloredText(ui::kDimText, "The project has changed since.");
    if (t.blind > 0)
        ui::coloredText(ui::kDimText, fmt::format("{} pictures see no grass; their steps count 0.", t.blind).c_str());
    ImGui::PopTextWrapPos();
}

TransitionColors themed() {
    TransitionColors c;
    c.ink = ui::hexOf(ImGui::GetColorU32(ImGuiCol_Text));
    c.dim = ui::hexOf(ui::kDimText), c.faint = ui::hexOf(ui::kFaintLine), c.floor = ui::hexOf(ui::kStrongLine);
    c.above = ui::hexOf(ui::kErrorText), c.below = ui::hexOf(ui::kFillHeld);
    return c;
}

std::string stepText(const Transitions& t, int step) {
    const auto i = static_cast<size_t>(step);
    return fmt::format("second {:.3g} to {:.3g}: {:.4f}, other blades {:.4f}", t.seconds[i], t.seconds[i + 1],
                       t.drawn.steps[i], t.floor.steps[i]);
}

constexpr float kLeastGraph = 100;  // points high

void graph(const TransitionParts& p, const Transitions& t) {
    const ImVec2 room = ImGui::GetContentRegionAvail(), at = ImGui::GetCursorScreenPos();
    const ImVec2 size(std::max(room.x, 120.f), std::max(room.y, kLeastGraph));
    const bool pressed = ImGui::InvisibleButton("Graph", size);
    ui::record("Graph", ui::Kind::Area, p.meter.shown < 0 ? "" : stepText(t, p.meter.shown));
    const PlotBox box{52, 8, static_cast<double>(size.x) - 8, static_cast<double>(size.y) - 34};
    const int under =
        ImGui::IsItemHovered() ? stepAt(t, box, static_cast<double>(ImGui::GetIO().MousePos.x - at.x)) : -1;
    if (pressed) goTo(p, under);
    Plot plot;
    addTransitionGraph(plot, t, box, themed(), under >= 0 ? under : p.meter.shown);
    ui::drawPlot(plot, at);
    if (under >= 0) ImGui::SetTooltip("%s\nClick to look from there.", stepText(t, under).c_str());
}

}  // namespace

void drawTransitions(const TransitionParts& p) {
    if (!p.doc.isOpen()) return ImGui::TextDisabled("No project is open.");
    const std::vector<std::string> paths = filmPaths(p.doc.project());
    if (paths.empty())
        return ImGui::TextDisabled("No entity has a CameraPath with keys: add one, and take its keys from the view.");
    controls(p, paths);
    if (!p.meter.error.empty()) {
        ImGui::PushTextWrapPos(0);
        ui::coloredText(ui::kErrorText, p.meter.error.c_str());
        ImGui::PopTextWrapPos();
        ui::record("Error", ui::Kind::Label, p.meter.error);
    }
    if (!p.meter.result) return;
    ImGui::BeginChild("result");
    summary(p, *p.meter.result);
    graph(p, *p.meter.result);
    ImGui::EndChild();
}

}  // namespace sward
