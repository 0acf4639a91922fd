#include "panels/map_windows.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "app/edits.h"
#include "app/messages.h"
#include "app/waiting.h"
#include "core/log.h"
#include "model/document.h"
#include "model/layer_edits.h"
#include "tools/camera_control.h"
#include "ui/theme.h"
#include "ui/widgets.h"
#include "ui/words.h"
#include "world/ground.h"
#include "world/height_layers.h"

namespace sward {
namespace {

constexpr double kLookFrom = 12;  // metres from which the view looks at a fault
constexpr int kWindow = ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoCollapse;

void flyTo(FlyCamera& camera, const Document& doc, const glm::dvec2& place) {
    const Ground ground = doc.ground();
    if (!ground.terrain) return;
    focus(camera, ground.origin + glm::dvec3(place.x, terrainHeight(*ground.terrain, place.x, place.y), place.y),
          kLookFrom);
}

void findings(const MapHealthView& view, const Document& doc, FlyCamera& camera, Edits& edits) {
    int line = 0;
    for (const MapFinding& f : view.findings) {
        const ui::Scope scope(std::to_string(line++));
        ImGui::PushID(line);
        ui::coloredText(f.meant ? ui::kDimText : ui::kErrorText, f.meant ? "  may be" : "  fault");
        ImGui::SameLine(ImGui::GetFontSize() * 4);
        if (ui::button("Go")) edits.deferred.push_back([&camera, &doc, place = f.worst] { flyTo(camera, doc, place); });
        ui::tooltip(fmt::format("Flies to where it is worst: {:.1f}, {:.1f} m", f.worst.x, f.worst.y));
        ImGui::SameLine();
        const std::string text = ui::inWords(f.map) + ": " + f.message;
        ImGui::PushTextWrapPos(0);  // of lines longer than the window none ends at its edge
        ImGui::TextUnformatted(text.c_str());
        ImGui::PopTextWrapPos();
        ui::record("Line", ui::Kind::Label, text);
        ImGui::PopID();
    }
}

// A number of the placing; two decimals are enough.
void metres(const char* label, double& value, double low, double high) {
    float v = static_cast<float>(value);
    ImGui::SetNextItemWidth(ImGui::GetFontSize() * 7);
    ui::NumberSpec spec;
    spec.softMin = low, spec.softMax = high, spec.hardMin = -1e6, spec.hardMax = 1e6, spec.unit = "m";
    ImGui::AlignTextToFramePadding();
    ui::coloredText(ui::kDimText, label);
    ImGui::SameLine(ImGui::GetFontSize() * 5);
    if (ui::slider(label, v, spec)) value = static_cast<double>(v);
    const std::string* error = ui::errorAt(label);
    if (error) ui::tooltip(*error);
}

void takePlaced(HeightPlacing& h, Document& doc, Messages& messages, Waiting& waiting) {
    const auto beyond = std::make_shared<size_t>(0);
    editBeside(
        waiting, doc, "Placing heights",
        [source = h.source, place = h.place, beyond](Document& d, JobControl& c) {
            return placeHeights(d, source, place, beyond.get(), &c);
        },
        [&h, &messages, beyond](const Status& done) {
            h.error = done ? "" : done.error().text();
            if (!done) return;
            const std::string lost =
                *beyond > 0 ? fmt::format("; {} texels lay beyond heightRange and took its end", *beyond) : "";
            say(messages, "heights placed from " + h.file + lost);
            h = {};
        });
}

}  // namespace

void checkMaps(MapHealthView& view, const Document& doc, Waiting& waiting) {
    const auto rows = doc.tables().components;
    const auto copy = std::make_shared<const Project>(snapshot(doc.project(), rows));
    waitFor(
        waiting, "Looking through the maps",
        [&view, copy, rows, revision = doc.revision()](JobControl& c) -> Result<Taking> {
            MapHealthView found{true, revision, mapFindings(*copy, rows, &c), allMaps(*copy, rows).size()};
            if (c.cancelled()) return failed("looking through the maps was cancelled");
            std::stable_sort(found.findings.begin(), found.findings.end(),
                             [](const MapFinding& a, const MapFinding& b) { return a.meant < b.meant; });
            return Taking([&view, found = std::move(found)]() -> Status {
                view = found;
                return {};
            });
        },
        [](const Status& done) {
            if (!done) logInfo(done.error().text());
        });
}

void drawMapHealth(MapHealthView& view, const Document& doc, FlyCamera& camera, Edits& edits, Waiting& waiting) {
    if (!view.open) return;
    const float em = ImGui::GetFontSize();
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowSize({std::min(em * 52, screen.x - em * 7), std::min(em * 14, screen.y - em * 9)},
                             ImGuiCond_Appearing);
    ImGui::SetNextWindowPos({em * 6, em * 8}, ImGuiCond_Appearing);
    if (ImGui::Begin("Map health", &view.open, kWindow)) {
        const size_t faults = static_cast<size_t>(
            std::count_if(view.findings.begin(), view.findings.end(), [](const MapFinding& f) { return !f.meant; }));
        const std::string told =
            fmt::format("{} map{}: {} fault{}, {} that may be meant{}", view.maps, view.maps == 1 ? "" : "s", faults,
                        faults == 1 ? "" : "s", view.findings.size() - faults,
                        view.revision == doc.revision() ? "" : "; the project changed since");
        ImGui::AlignTextToFramePadding();
        ImGui::TextUnformatted(told.c_str());
        ui::record("Told", ui::Kind::Label, told);
        ImGui::SameLine();
        if (ui::button("Check again"))
            edits.deferred.push_back([&view, &doc, &waiting] { checkMaps(view, doc, waiting); });
        ImGui::SameLine();
        if (ui::button("Close")) view.open = false;
        ImGui::BeginChild("findings");
        findings(view, doc, camera, edits);
        ImGui::EndChild();
    }
    ImGui::End();
}

void beginPlacing(HeightPlacing& h, const Document& doc, Waiting& waiting, const std::string& file, bool flipX,
                  bool flipZ, WaitedEnd then) {
    const Ground ground = doc.isOpen() ? doc.ground() : Ground{};
    if (!ground.terrain) return then(usage("there is no terrain to place heights on", "add an entity with a Terrain"));
    HeightPlacing placing;
    placing.file = file;
    placing.place.flipX = flipX, placing.place.flipZ = flipZ;
    placing.place.at = ground.terrain->size / 4.0, placing.place.size = ground.terrain->size / 2.0;
    waitFor(
        waiting, "Reading " + std::filesystem::path(file).filename().string(),
        [&h, placing](JobControl& c) -> Result<Taking> {
            const Result<Map> source = readHeights(placing.file);
            if (!source) return source.error();
            if (c.cancelled()) return failed("reading the heights was cancelled");
            return Taking([&h, placing, map = *source]() -> Status {
                h = placing;
                h.source = map;
                return {};
            });
        },
        std::move(then));
}

void drawHeightPlacing(HeightPlacing& h, Document& doc, Edits& edits, Messages& messages, Waiting& waiting) {
    if (h.file.empty()) return;
    const Ground ground = doc.isOpen() ? doc.ground() : Ground{};
    if (!ground.terrain) {
        h = {};
        return;
    }
    const glm::dvec2 size = ground.terrain->size;
    const float em = ImGui::GetFontSize();
    ImGui::SetNextWindowPos({em * 6, em * 8}, ImGuiCond_Appearing);
    if (ImGui::Begin("Place heights", nullptr, kWindow | ImGuiWindowFlags_AlwaysAutoResize)) {
        metres("X", h.place.at.x, 0, size.x);
        metres("Z", h.place.at.y, 0, size.y);
        metres("Width", h.place.size.x, 1, size.x);
        metres("Depth", h.place.size.y, 1, size.y);
        if (h.source.info().type != PixelType::F32) {
            metres("Black", h.place.low, -50, 50);
            metres("White", h.place.high, -50, 200);
        }
        ImGui::AlignTextToFramePadding();
        ui::coloredText(ui::kDimText, "Falloff");
        ImGui::SameLine(em * 5);
        ImGui::SetNextItemWidth(em * 7);
        ui::NumberSpec share;
        share.hardMin = 0, share.hardMax = 1;
        ui::slider("Falloff", h.place.falloff, share);
        ui::tooltip("0: a hard edge; 1: the picture fades in as far as its middle.");
        ui::checkbox("Flip X", h.place.flipX);
        ImGui::SameLine();
        ui::checkbox("Flip Z", h.place.flipZ);
        if (const std::string below = sculptsBelow(doc, heightsPath(doc.project())); !below.empty()) {
            ui::coloredText(ui::kErrorText, ("They go " + below).c_str());
            ui::tooltip(kSculptsBelow);
            ui::record("Below", ui::Kind::Label, below);
        }
        if (!h.error.empty()) {
            ui::coloredText(ui::kErrorText, h.error.c_str());
            ui::record("Error", ui::Kind::Label, h.error);
        }
        if (ui::button("Accept", em * 6, true))
            edits.deferred.push_back([&h, &doc, &messages, &waiting] { takePlaced(h, doc, messages, waiting); });
        ImGui::SameLine();
        if (ui::button("Cancel", em * 6)) h = {};
    }
    ImGui::End();
}

}  // namespace sward
