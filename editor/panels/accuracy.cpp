// What accuracy costs: the comparison's choices and scores, the project's time-appearance plot, a fit to a budget.
#include <fmt/format.h>
#include <imgui.h>

#include "accuracy/accuracy.h"

#include <cmath>
#include "app/edits.h"
#include "app/frame_clock.h"
#include "app/messages.h"
#include "panels/accuracy_plot.h"
#include "panels/field_edit.h"
#include "panels/panels.h"
#include "scene/forest_technique.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace sward {
namespace {

void choices(Comparison& c, std::span<const std::string> techniques, double now) {
    if (!ImGui::BeginTable("choices", 2)) return;
    ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthFixed, ImGui::GetFontSize() * 4.2f);
    ImGui::TableSetupColumn("value");
    const std::vector<std::string> against = comparisonNames(c, techniques);
    int chosen = comparisonChosen(c, techniques);
    caption("Against",
            "What is shown right of the line in the viewport: the ray-traced truth, or another way of drawing the same "
            "grass or trees.");
    if (ui::combo("Against", against, chosen)) chooseComparison(c, now, techniques, chosen);
    const ui::Disabled off(c.against == Against::Off);
    const std::vector<std::string> shows(std::begin(kCompareShows), std::end(kCompareShows));
    int show = static_cast<int>(c.show);
    caption("Show", "split: the other picture right of the line.  error: where the two differ, dark where they agree.");
    if (ui::combo("Show", shows, show)) c.show = static_cast<CompareShow>(show), c.heatDue = true;
    caption("Split", "Where the line is; drag its grip in the viewport.");
    ui::NumberSpec spec;
    spec.hardMin = 0, spec.hardMax = 1;
    ui::slider("Split", c.split, spec);
    const std::vector<std::string> metrics(std::begin(kErrorMetrics), std::end(kErrorMetrics));
    int metric = static_cast<int>(c.metric);
    caption("Error",
            "appearance: does it look the same, whichever blade stands where.  flip: what an eye sees when pictures "
            "alternate.\nrmse: pixel by pixel.  ssim: structure, pixel by pixel.");
    if (ui::combo("Metric", metrics, metric)) chooseMetric(c, static_cast<ErrorMetric>(metric));
    ImGui::EndTable();
}

void score(const char* label, const std::string& text, const char* help) {
    ui::coloredText(ui::kDimText, label);
    ImGui::SameLine(0, 5);
    ImGui::TextUnformatted(text.c_str());
    ui::record(label, ui::Kind::Label, text);
    ui::tooltip(help);
}

void scores(const Comparison& c, const std::string& label) {
    if (c.against == Against::Off) return ImGui::TextDisabled("Choose what to compare with.");
    if (!c.metrics) return ui::coloredText(ui::kDimText, c.picture.id() == 0 ? label.c_str() : "no grass is in view");
    const Metrics& m = *c.metrics;
    score("appearance", fmt::format("{:.4f} \xC2\xB1 {:.3f}", m.appearance.distance, m.appearance.sigma),
          "How different the grass looks: 0 is the same, 0.2 another material. The second number is how far chance "
          "moves it.");
    score("brightness", fmt::format("{:.4f}", m.appearance.bias),
          "The part of it that is a wrong mean colour or brightness (bias).");
    score("contrast", fmt::format("{:.4f}", m.appearance.contrast), "The part of it that is too flat or too busy.");
    score("flip", fmt::format("{:.3f}", m.flip),
          "What an eye notices when the two pictures alternate: 0 nothing, 1 most.");
    if (c.against != Against::Reference) return;
    score("samples", fmt::format("{} of {}", c.sum.passes, kMostPasses),
          "Rays a pixel so far. More come while nothing moves.");
    score("truth's noise", c.sum.passes > 1 ? fmt::format("{:.4f}", c.truthError) : "unknown yet",
          "Mean standard error of the truth's pixels, in linear light; it halves with four times the samples.");
}

void sweepRow(Sweep& s, const MeasureParts& parts) {
    if (s.running()) {
        if (ui::button("Stop")) stopSweep(s);
        ImGui::SameLine(0, 8);
        const std::string news = newsText(s.news, parts.clock.now);
        ui::coloredText(ui::kDimText, news.c_str());
        ui::record("Measuring", ui::Kind::Label, news);
        ui::tooltip("Measuring from " + s.camera + ". First the truth, then every setting, then their times.");
        return;
    }
    const ui::Disabled none(!parts.doc.isOpen());
    if (ui::button("Measure")) startSweep(s, parts);
    ui::tooltip(
        "Draws this project from here with every technique at many settings, and holds each against the truth. Takes "
        "some minutes, beside the editor;\nthe project is copied as it is now, unsaved work included.");
    ImGui::SameLine(0, 8);
    if (!s.error.empty())
        ui::coloredText(ui::kErrorText, s.error.c_str());
    else
        ui::coloredText(ui::kDimText,
                        s.run ? fmt::format("{} settings. Click one to adopt it.", s.run->rows.size()).c_str()
                              : "Each way to draw, measured.");
    if (!s.error.empty()) ui::tooltip(s.error);
}

void adopt(Document& doc, Edits& edits, Messages& messages, const CostSetting& setting) {
    edits.deferred.push_back([&doc, &messages, setting] {
        const auto left = adoptSettings(doc, setting);
        if (!left) return showError(messages, left.error());
        say(messages, adoptedText(setting, *left));
    });
}

void plotColumn(Accuracy& accuracy, const MeasureParts& parts, Edits& edits, double lastMs) {
    sweepRow(accuracy.sweep, parts);
    const Comparison& c = accuracy.comparison;
    std::optional<ViewportPoint> viewport;
    if (c.against == Against::Reference && c.metrics && lastMs > 0)
        viewport = ViewportPoint{lastMs, c.metrics->appearance.distance};
    if (const auto chosen =
            drawCostPlot(accuracy.sweep.run, parts.doc, parts.doc.revision() == accuracy.sweep.revision, viewport))
        adopt(parts.doc, edits, parts.messages, *chosen);
}

// Three digits, and never an exponent.
std::string milliseconds(double ms) { return ms < 1000 ? fmt::format("{:.3g}", ms) : fmt::format("{:.0f}", ms); }

void fitResult(Accuracy& accuracy, const MeasureParts& parts, Edits& edits) {
    Fit& f = accuracy.fit;
    if (!f.error.empty()) return ImGui::TextWrapped("%s", f.error.c_str());
    if (!f.result) return ImGui::TextWrapped("%s", "Finds the tiers that look truest within this time a frame.");
    const FitShown& r = *f.result;
    const CostSetting setting = settingOf(r.technique, r.settings);
    if (ui::button("Preview")) previewSettings(accuracy.comparison, parts.clock.now, setting);
    ui::tooltip("Shows these settings right of the line in the viewport; the project stays as it is.");
    ImGui::SameLine(0, 6);
    if (ui::button("Adopt", 0, true)) adopt(parts.doc, edits, parts.messages, setting);
    ui::tooltip("Sets them in the project: one undo step.\n" + r.settings);
    ImGui::PushTextWrapPos(0);
    const std::string error = std::isfinite(r.appearance) ? fmt::format(", error {:.4f}", r.appearance) : "";
    ImGui::TextUnformatted(
        fmt::format("{}{} ms{}  (now {} ms{})", r.fits ? "" : "Nothing fits. The quickest: ", milliseconds(r.ms), error,
                    milliseconds(r.shippedMs),
                    std::isfinite(r.shippedAppearance) ? fmt::format(", {:.4f}", r.shippedAppearance) : "")
            .c_str());
    ui::record("Fitted", ui::Kind::Label, r.settings);
    ui::tooltip(r.settings);
    if (r.fits)
        ui::coloredText(ui::kDimText,
                        ("gives up: " + (r.better.empty() ? "nothing better was seen" : r.better)).c_str());
    if (r.cutShort) ui::coloredText(ui::kDimText, "the best so far: with more time there may be better");
    if (!r.outcome.empty()) ui::coloredText(ui::kDimText, r.outcome.c_str());
    ImGui::PopTextWrapPos();
}

void searchTime(Fit& f) {
    ImGui::AlignTextToFramePadding();
    ui::coloredText(ui::kDimText, "Search for");
    ImGui::SameLine(0, 5);
    ImGui::SetNextItemWidth(ImGui::GetFontSize() * 4.2f);
    ui::NumberSpec spec;
    spec.softMin = 0.5, spec.softMax = 20, spec.hardMin = 0.1, spec.hardMax = 600, spec.unit = "min";
    ui::slider("Search for", f.minutes, spec);
    ui::tooltip("How long it may take, or little more. The best so far is shown meanwhile.");
}

// Where there are both.
void whatIsTurned(Fit& f, const Project& project) {
    if (fieldsOf(project).empty() || growingForests(project).empty()) return;
    ui::checkbox("Of the forest", f.forests);
    ui::tooltip("Turns how the forest is drawn; else, how the grass is. The other stays as it is.");
}

void fitColumn(Accuracy& accuracy, const MeasureParts& parts, Edits& edits) {
    Fit& f = accuracy.fit;
    ImGui::AlignTextToFramePadding();
    ui::coloredText(ui::kDimText, "Budget");
    ImGui::SameLine(0, 5);
    ImGui::SetNextItemWidth(ImGui::GetFontSize() * 4.2f);
    ui::NumberSpec spec;
    spec.softMin = 1, spec.softMax = 100, spec.hardMin = 0.01, spec.hardMax = 1e5, spec.unit = "ms";
    ui::slider("Budget", f.budget, spec);
    ui::tooltip("What a frame of 320 x 240 may take on this machine, in milliseconds.");
    ui::beside(ImGui::CalcTextSize("Fit to budget").x + 2 * ImGui::GetStyle().FramePadding.x);
    if (f.running()) {
        if (ui::button("Stop fit")) stopFit(f);
        ui::tooltip("Ends the search. The best so far stays here, to be adopted.");
        ImGui::TextWrapped("%s", newsText(f.news, parts.clock.now).c_str());
        if (!f.result) return;
    } else {
        const ui::Disabled none(!parts.doc.isOpen());
        if (ui::button("Fit to budget")) startFit(f, parts);
        searchTime(f);
        if (parts.doc.isOpen()) whatIsTurned(f, parts.doc.project());
    }
    fitResult(accuracy, parts, edits);
}

}  // namespace

void drawAccuracy(Accuracy& accuracy, const MeasureParts& parts, Edits& edits, double lastMs) {
    Comparison& c = accuracy.comparison;
    ImGui::BeginChild("accuracy");
    const float ems = ImGui::GetContentRegionAvail().x / ImGui::GetFontSize();
    const int columns = ems < 40 ? 1 : 3;  // what does not fit beside goes below
    if (ImGui::BeginTable("columns", columns, ImGuiTableFlags_SizingStretchProp)) {
        for (const float share : {1.1f, 2.2f, 1.25f})
            if (columns == 3) ImGui::TableSetupColumn("", 0, share);
        ImGui::TableNextColumn();
        ImGui::PushTextWrapPos(0);
        const Project none;
        choices(c, comparedTechniques(parts.doc.isOpen() ? parts.doc.project() : none, parts.doc.tables()),
                parts.clock.now);
        scores(c, comparisonLabel(c, parts.doc, parts.clock));
        ImGui::PopTextWrapPos();
        ImGui::TableNextColumn();
        plotColumn(accuracy, parts, edits, lastMs);
        ImGui::TableNextColumn();
        fitColumn(accuracy, parts, edits);
        ImGui::EndTable();
    }
    ImGui::EndChild();
}

}  // namespace sward
