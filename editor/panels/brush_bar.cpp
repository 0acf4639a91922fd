// The brush bar: what the brush paints on and how. Each tool and map has settings of its own.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/edits.h"
#include "app/messages.h"
#include "model/layer_edits.h"
#include "model/new_map.h"
#include "panels/bar_rows.h"
#include "panels/brush_shape.h"
#include "panels/panels.h"
#include "tools/brush_target.h"
#include "tools/object_tool.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace sward {
namespace {

using namespace bar;

void mapCombo(Rows& rows, const Document& doc, BrushBook& brushes) {
    std::vector<std::string> names, paths;
    for (const ConstFieldRef& map : paintableMaps(doc)) {
        paths.push_back(map.path);
        names.push_back(static_cast<const MapField*>(map.value)->present() ? map.path : map.path + " (new)");
    }
    const auto it = std::find(paths.begin(), paths.end(), brushes.map);
    int chosen = it == paths.end() ? -1 : static_cast<int>(it - paths.begin());
    next(rows, "Map", em(21) + 80);
    caption("Map");
    ImGui::SetNextItemWidth(em(21));
    if (ui::combo("Map", names, chosen)) selectMap(doc, brushes, paths[static_cast<size_t>(chosen)]);
    const std::optional<ConstFieldRef> map = chosenMap(doc, brushes);
    ui::tooltip("The map that the brush paints" + (map ? fmt::format(": {}.\n{}", map->row->help, map->path) : "."));
    ImGui::SameLine(0, 5);
    if (ui::button("Overlay", 0, overlayShown(doc, brushes))) toggleOverlay(doc, brushes);
    ui::tooltip("Shows the map as a colour over the scene (O).");
}

// One click makes the map that is not there; without one there is nothing to see or paint.
void createButton(Rows& rows, Document& doc, const ConstFieldRef& map, Edits& edits, Messages& messages) {
    const std::string size = describeNewMap(doc.project(), map), path = map.path;
    const std::string shortly = size.substr(0, size.find(" texels"));
    next(rows, shortly.c_str(), em(7));
    if (ui::button("Create map", 0, true))
        edits.deferred.push_back([&doc, &messages, path, size] {
            if (accept(messages, doc.createMap(path))) say(messages, fmt::format("new map {}: {}", path, size));
        });
    ui::tooltip("The project has no " + path + " yet.\nMakes it: " + size +
                ". The first stroke does so too; undo takes it back.");
    ImGui::SameLine(0, 8);
    ImGui::AlignTextToFramePadding();
    ui::coloredText(ui::kDimText, shortly.c_str());
    ui::record("New map", ui::Kind::Label, size);
}

// The path tool is a mode of the select tool; here each has its own name.
void modeCombo(const Document& doc, BrushBook& brushes, GizmoMode& mode, Messages& messages) {
    std::vector<std::string> labels{"Select", "Path"}, tools{kViewTool, kViewTool};
    for (const BrushRow& row : brushRows()) labels.push_back(row.label), tools.push_back(row.name);
    const auto it = std::find(tools.begin(), tools.end(), brushes.tool);
    int chosen = static_cast<int>(it - tools.begin());
    if (chosen == 0 && mode == GizmoMode::Path) chosen = 1;
    caption("Mode");
    ImGui::SetNextItemWidth(em(7));
    if (!ui::combo("Mode", labels, chosen)) return;
    selectTool(doc, brushes, messages, tools[static_cast<size_t>(chosen)]);
    if (chosen == 1) mode = GizmoMode::Path;
    if (chosen == 0 && mode == GizmoMode::Path) mode = GizmoMode::Move;
}

// A compass that shows the angle as the eye sees it: up is away from the viewer. Pressed or dragged, it takes the
// pointer's direction.
void dial(double yaw, float& angleDeg) {
    const float side = ImGui::GetFrameHeight();
    ImGui::InvisibleButton("dial", {side, side});
    ui::record("Dial", ui::Kind::Area, ui::numberText(static_cast<double>(angleDeg)));
    const ImVec2 low = ImGui::GetItemRectMin(), c{low.x + side / 2, low.y + side / 2}, mouse = ImGui::GetIO().MousePos;
    const float yawDeg = static_cast<float>(glm::degrees(yaw)), dx = mouse.x - c.x, dy = mouse.y - c.y;
    if (ImGui::IsItemActive() && std::hypot(dx, dy) > 2) {
        const float turn = glm::degrees(std::atan2(dx, -dy)) + yawDeg;
        angleDeg = std::round(turn - 360 * std::floor(turn / 360));
    }
    ui::tooltip("Where the blades will lean, as seen from here: up is away from you.");
    const float a = glm::radians(angleDeg - yawDeg), r = side * 0.46f, x = std::sin(a), y = -std::cos(a);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddCircleFilled(c, r, ImGui::GetColorU32(ImGui::IsItemHovered() ? ImGuiCol_FrameBgHovered : ImGuiCol_FrameBg));
    list.AddCircle(c, r, ui::kDimText);
    list.AddLine({c.x - x * r * 0.6f, c.y - y * r * 0.6f}, {c.x + x * r * 0.6f, c.y + y * r * 0.6f}, ui::kStrongLine,
                 2);
    list.AddTriangleFilled({c.x + x * r, c.y + y * r},
                           {c.x + (x * 0.2f - y * 0.5f) * r, c.y + (y * 0.2f + x * 0.5f) * r},
                           {c.x + (x * 0.2f + y * 0.5f) * r, c.y + (y * 0.2f - x * 0.5f) * r}, ui::kStrongLine);
}

void angle(Rows& rows, double yaw, float& angleDeg) {
    number(rows, "Angle", angleDeg, em(5.5f), range(0, 360, -360, 360, "deg"),
           "Where the blades lean, clockwise from north (-z) seen from above.");
    ImGui::SameLine(0, 4);
    dial(yaw, angleDeg);
}

// What is laid on a map of colours: a swatch with a picker, and the colour as it is written in image programs.
void color(Rows& rows, BrushBook& brushes) {
    next(rows, "Colour", em(7) + ImGui::GetFrameHeight());
    caption("Colour");
    glm::vec3& chosen = currentColor(brushes);
    ui::srgbEdit("Colour/Swatch", &chosen.x);
    ui::tooltip("What the brush lays. Click to choose; I takes the map's colour under the pointer.");
    ImGui::SameLine(0, 4);
    ImGui::SetNextItemWidth(em(5.5f));
    if (const auto typed = ui::textField("Colour", colorText(chosen))) {
        const std::optional<glm::vec3> parsed = parseColor(*typed);
        ui::setError("Colour",
                     parsed ? "" : "a colour is written as #e5c81a: two digits 0 to f each of red, green and blue");
        if (parsed) chosen = *parsed;
    }
    const std::string* error = ui::errorAt("Colour");
    ui::tooltip(error ? *error : "Red, green and blue as #rrggbb.");
}

// What tools need beyond size and strength where they paint heights.
void heights(Rows& rows, BrushSettings& b) {
    const ui::NumberSpec metres = range(0, 2, -1e5, 1e5, "m");
    if (b.mode == "raise" || b.mode == "lower" || b.mode == "noise")
        number(rows, "Height", b.value, em(7), metres,
               "What a stamp changes at full strength. A stroke puts about seven stamps over each place; how fast the "
               "hand goes does not matter.");
    if (b.mode == "noise")
        number(rows, "Bumps", b.bumpSize, em(7), range(0, 50, 0, 1e6, "m"),
               "How wide the widest bumps are; 0: as the brush's radius.");
    if (b.mode == "flatten") {
        next(rows, "From start", em(6));
        ui::checkbox("From start", b.fromStart);
        ui::tooltip(
            "To the height where the stroke begins; else to the height beside. I takes the one under the pointer.");
        const ui::Disabled unused(b.fromStart);
        number(rows, "Height", b.value, em(7), range(-10, 100, -1e5, 1e5, "m"),
               "The height that the ground is levelled to.");
    }
    if (b.mode == "imprint") imprintWidgets(rows, b);
    if (b.mode == "erode") {
        number(rows, "Water", b.water, em(5.5f), range(0, 1, 0, 1),
               "How much rain falls and washes gullies; 0: slopes only slide.");
        number(rows, "Talus", b.talusDeg, em(6), range(10, 60, 0, 89, "deg"),
               "The steepest slope that stays: steeper ground slides. Dry sand rests at 35 degrees.");
    }
}

// A hill that an `add` layer lifts ends higher than it was flattened to: said beside the tool.
void belowLayers(Rows& rows, const Document& doc, const std::string& map) {
    const std::string text = sculptsBelow(doc, map);
    if (text.empty()) return;
    next(rows, text.c_str(), 0);
    ImGui::AlignTextToFramePadding();
    ui::coloredText(ui::kErrorText, text.c_str());
    ui::tooltip(kSculptsBelow);
    ui::record("Below", ui::Kind::Label, text);
}

// The settings of the present tool on the present map.
void settings(Rows& rows, BrushBook& brushes, const std::optional<ConstFieldRef>& map, double yaw,
              const ShapeParts& shapes) {
    BrushSettings& b = currentBrush(brushes);
    const bool lays = b.mode == "comb" || b.mode == "direction", presses = b.mode == "press";
    number(rows, "Radius", b.radius, em(7.5f), range(0.1, 30, 0.05, 500, "m"), "Size of the brush: [ and ] change it.");
    number(rows, "Strength", b.strength, em(5.5f), range(0, 1, 0, 1),
           lays               ? "How far the blades lean over: - and = change it."
           : b.mode == "ramp" ? "How far the ground goes to the ramp: 1 is all the way."
           : presses          ? "How flat the blades are pressed, and how far pushed: - and = change it."
                              : "How much one pass over a place changes it: - and = change it.");
    if (!b.shape || b.mode == "ramp" || (b.mode == "imprint" && b.blend != HeightBlend::Add))
        number(rows, "Falloff", b.falloff, em(5.5f), range(0, 1, 0, 1),
               "0: a hard edge; 1: weaker from the centre on.");
    if (b.mode != "ramp") shapeWidgets(rows, brushes, shapes);
    if (b.mode == "direction") angle(rows, yaw, b.angleDeg);
    const bool colours = map && map->row->map->kind == MapKind::Colours;
    if (colours) color(rows, brushes);
    if (colours && paints(*findBrush(b.mode), MapKind::Colours) && b.mode != "subtract" && b.mode != "smooth")
        number(rows, "Opacity", b.value, em(5.5f), range(0, 1, 0, 1),
               "How far the colour covers what lies under the map; 1: wholly.");
    if (map && map->row->map->kind == MapKind::Heights) heights(rows, b);
    if (b.mode == "set" && !colours)
        number(rows, "Value", b.value, em(5.5f), range(0, 1, 0, 1),
               "What the brush paints towards: 0 is bare, 1 is full.");
}

// What the button does with the path tool in the hand.
void pathHelp(Rows& rows) {
    constexpr const char* kHelp =
        "A click on the ground adds a point, on the curve inserts one; a drag moves it, Delete removes it, Enter ends.";
    next(rows, kHelp, 0);
    ImGui::AlignTextToFramePadding();
    ui::coloredText(ui::kDimText, kHelp);
    ui::record("Path Help", ui::Kind::Label);
    ui::tooltip("Width, falloff and tint of the path are in the inspector.");
}

// Of the select tool: to what a drag snaps while Ctrl is held.
void steps(Rows& rows, ObjectTool& objects) {
    GizmoSteps& s = objects.steps;
    number(rows, "Grid", s.grid, em(6), range(0.05, 5, 0.001, 1000, "m"),
           "With Ctrl held, what is moved snaps to places so far apart.");
    number(rows, "Turn step", s.angleDeg, em(6), range(1, 90, 0.01, 180, "deg"),
           "With Ctrl held, what is turned snaps to steps of so much.");
    number(rows, "Scale step", s.scale, em(5), range(0.01, 1, 0.001, 10),
           "With Ctrl held, a factor snaps to multiples of this.");
    next(rows, "Follow ground", em(2));
    ui::checkbox("Follow ground", objects.alongGround);
    ui::tooltip("What is moved keeps its height over the ground. Objects that stand on the ground always do.");
}

}  // namespace

int drawBrushBar(const Rect& area, double yaw, Document& doc, BrushBook& brushes, ObjectTool& objects, Edits& edits,
                 Messages& messages, ImageDialog& images, Waiting& waiting) {
    Rows rows{area.x + area.w};
    const ui::Disabled noProject(!doc.isOpen());
    modeCombo(doc, brushes, objects.mode, messages);
    mapCombo(rows, doc, brushes);
    const std::optional<ConstFieldRef> map = chosenMap(doc, brushes);
    if (brushes.tool == kViewTool) {
        if (objects.mode == GizmoMode::Path)
            pathHelp(rows);
        else
            steps(rows, objects);
        return rows.count;
    }
    if (map && !static_cast<const MapField*>(map->value)->present()) createButton(rows, doc, *map, edits, messages);
    settings(rows, brushes, map, yaw, {doc, edits, messages, images, waiting});
    if (map) belowLayers(rows, doc, map->path);
    speciesWidgets(rows, doc, brushes);
    mirrorWidget(rows, brushes);
    return rows.count;
}

}  // namespace sward
