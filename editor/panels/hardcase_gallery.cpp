#include "panels/hardcase_gallery.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "formulas/case_plot.h"
#include "ui/plot_view.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace sward {
namespace {

// As people read it and scripts find it.
std::string labelOf(const HardCase& h) { return h.key + "  " + h.row.name; }

std::string verdictOf(const HardCaseRow& r) {
    if (r.pass) return "ok";
    return r.fault.empty() ? "failing" : "not run";
}

std::string verdictHelp(const HardCaseRow& r) {
    std::string out = fmt::format("as printed off by {}, ours by {} on this CPU",
                                  r.hasPublished ? caseNumber(r.published) : "(no such form)", caseNumber(r.oursCpu));
    if (r.hasGpu) out += fmt::format(" and {} on this GPU", caseNumber(r.oursGpu));
    out += fmt::format("; allowed are {}", caseNumber(r.tolerance));
    if (r.gpuTolerance > r.tolerance) out += fmt::format(", on a GPU {}", caseNumber(r.gpuTolerance));
    return r.fault.empty() ? out : r.fault;
}

void verdict(const HardCaseRun& run, size_t i) {
    if (i >= run.results.size()) return ImGui::TextDisabled("...");
    const HardCaseRow& r = run.results[i];
    ui::coloredText(r.pass ? ui::kAccent : ui::kErrorText, verdictOf(r).c_str());
    ui::record("Verdict", ui::Kind::Label, verdictOf(r));
    ui::tooltip(verdictHelp(r));
}

void caseRow(HardCaseRun& run, Edits& edits, size_t i) {
    const HardCase& h = run.cases[i];
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    if (ui::selectable(labelOf(h), run.shown == i)) edits.deferred.push_back([&run, i] { showCase(run, i); });
    ui::tooltip(h.row.name + "\nUsed by: " + h.curve.where);
    const ui::Scope scope(h.key);
    ImGui::TableNextColumn();
    verdict(run, i);
}

void list(HardCaseRun& run, Edits& edits) {
    if (!ImGui::BeginTable("cases", 2)) return;
    ImGui::TableSetupColumn("case");
    ImGui::TableSetupColumn("verdict", ImGuiTableColumnFlags_WidthFixed, ImGui::GetFontSize() * 3.2f);
    for (size_t i = 0; i < run.cases.size(); ++i) caseRow(run, edits, i);
    ImGui::EndTable();
}

void comboOfCases(HardCaseRun& run, Edits& edits) {
    std::vector<std::string> names;
    for (const HardCase& h : run.cases) names.push_back(labelOf(h));
    int chosen = static_cast<int>(run.shown);
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - ImGui::GetFontSize() * 4);
    if (ui::combo("Case", names, chosen))
        edits.deferred.push_back([&run, chosen] { showCase(run, static_cast<size_t>(chosen)); });
    ImGui::SameLine();
    verdict(run, run.shown);
}

// What the case is, who uses it, and the button that shows its formula.
void heading(HardCaseRun& run, const HardCase& h) {
    if (ui::button(h.curve.source, 0, run.sourceOpen)) run.sourceOpen = !run.sourceOpen;
    ui::tooltip("Shows " + h.curve.function + " as it stands in shaders/numerics/" + h.curve.source +
                ", with the printed form: the text that C++, shaders and this graph run.");
    ImGui::SameLine(0, 8);
    ui::coloredText(ui::kDimText, ("used by: " + h.curve.where).c_str());
    ui::record("Used by", ui::Kind::Label, h.curve.where);
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(h.curve.picture.c_str());
    if (!isSwept(h)) ui::coloredText(ui::kDimText, h.curve.whyNot.c_str());
    ImGui::PopTextWrapPos();
    ui::record("Picture", ui::Kind::Label, h.curve.picture);
}

std::string formText(const char* name, double value, double error) {
    const std::string off = std::isfinite(error) ? " (off by " + caseNumber(error) + ")" : "";
    return fmt::format(", {} {}{}", name, caseNumber(value), off);
}

std::string numbersAt(const HardCase& h, const CasePoint& p) {
    const auto output = static_cast<size_t>(h.curve.output);
    std::string out = "wanted " + caseNumber(p.truth[output]);
    if (!p.published.empty()) out += formText("as printed", p.published[output], p.publishedError);
    return out + formText("ours", p.ours[output], p.oursError);
}

void slider(HardCaseRun& run, const HardCase& h) {
    const CaseCurve& c = h.curve;
    ui::NumberSpec spec;
    spec.hardMin = c.zero ? 0 : c.low, spec.hardMax = c.high;
    spec.integer = c.whole, spec.unit = c.unit;
    spec.softMin = spec.softMax = 0;  // without ends: a logarithmic axis is dragged by shares of the value
    if (c.scale == CaseScale::Even) spec.softMin = c.low, spec.softMax = c.high;
    double at = run.here.at;
    ImGui::SetNextItemWidth(ImGui::GetFontSize() * 9);
    const ui::NumberEdit edit = ui::number("At", at, spec);
    std::string error;
    if (edit.typed) {
        const auto typed = ui::parseNumber(*edit.typed, spec, error);
        ui::setError("At", error);
        if (typed) moveCase(run, *typed);
    } else if (edit.changed) {
        moveCase(run, at);
    }
    const std::string* wrong = ui::errorAt("At");
    ui::tooltip(wrong ? *wrong : c.variable + ". Drag it here or in a graph, or type it.");
    ImGui::SameLine(0, 8);
    const std::string numbers = numbersAt(h, run.here);
    const bool bad = !run.here.published.empty() && !(run.here.publishedError <= h.row.tolerance);
    ImGui::PushTextWrapPos(0);
    ui::coloredText(bad ? ui::kWarningText : ui::kDimText, numbers.c_str());
    ImGui::PopTextWrapPos();
    ui::record("Here", ui::Kind::Label, numbers);
}

CaseColors themed() {
    CaseColors c;
    c.ink = ui::hexOf(ImGui::GetColorU32(ImGuiCol_Text));
    c.dim = ui::hexOf(ui::kDimText), c.faint = ui::hexOf(ui::kFaintLine);
    c.published = ui::hexOf(ui::kErrorText), c.ours = ui::hexOf(ui::kAccent), c.truth = ui::hexOf(ui::kLine);
    return c;
}

void graph(HardCaseRun& run, const HardCase& h, CaseGraph which, ImVec2 size) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const char* name = which == CaseGraph::Values ? "Values" : "Errors";
    ImGui::InvisibleButton(name, size);
    ui::record(name, ui::Kind::Area);
    const auto width = static_cast<double>(size.x), height = static_cast<double>(size.y);
    const PlotBox box{56, 20, width - 12, height - 36};
    const double share = (static_cast<double>(ImGui::GetIO().MousePos.x - at.x) - box.left) / (box.right - box.left);
    if (ImGui::IsItemActive()) moveCase(run, valueAt(h.curve, share));
    Plot plot;
    addCaseGraph(plot, h, run.points, which, box, themed(), run.here.at);
    ui::drawPlot(plot, at);
    if (!ImGui::IsItemHovered() || ImGui::IsItemActive()) return;
    const double under = valueAt(h.curve, share);
    const auto nearest = std::min_element(run.points.begin(), run.points.end(), [&](const auto& a, const auto& b) {
        return std::abs(shareOn(h.curve, a.at) - shareOn(h.curve, under)) <
               std::abs(shareOn(h.curve, b.at) - shareOn(h.curve, under));
    });
    ImGui::SetTooltip("%s %s\n%s", caseNumber(nearest->at).c_str(), h.curve.unit.c_str(),
                      numbersAt(h, *nearest).c_str());
}

constexpr float kLeastGraph = 130;  // points high

// Side by side where there is room, else one below the other.
void graphs(HardCaseRun& run, const HardCase& h) {
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const bool beside = room.x > ImGui::GetFontSize() * 38;
    const float width = beside ? (room.x - 8) / 2 : room.x;
    const ImVec2 size(std::max(width, 120.f), std::max(room.y, kLeastGraph));
    graph(run, h, CaseGraph::Errors, size);
    if (beside) ImGui::SameLine(0, 8);
    graph(run, h, CaseGraph::Values, size);
}

void shownCase(HardCaseRun& run) {
    const HardCase& h = run.cases[run.shown];
    heading(run, h);
    if (run.sourceOpen) {
        ImGui::BeginChild("source", {0, 0}, true, ImGuiWindowFlags_HorizontalScrollbar);
        ImGui::TextUnformatted(run.source.c_str());
        ui::record("Source", ui::Kind::Label, run.source);
        return ImGui::EndChild();
    }
    if (run.pointsOf != run.shown || run.points.empty()) return;
    slider(run, h);
    graphs(run, h);
}

}  // namespace

void drawHardCases(HardCaseRun& run, Edits& edits) {
    run.looked = true;
    if (run.cases.empty()) return ImGui::TextDisabled("...");
    if (!run.error.empty()) ui::coloredText(ui::kErrorText, run.error.c_str());
    const bool narrow = ImGui::GetContentRegionAvail().x < ImGui::GetFontSize() * 36;
    if (narrow) {
        comboOfCases(run, edits);
    } else {
        ImGui::BeginChild("list", {ImGui::GetContentRegionAvail().x * 0.3f, 0});
        list(run, edits);
        ImGui::EndChild();
        ImGui::SameLine();
    }
    ImGui::BeginChild("case");
    shownCase(run);
    ImGui::EndChild();
}

}  // namespace sward
