#include "panels/brush_shape.h"

#include <imgui.h>

#include <algorithm>

#include "app/edits.h"
#include "app/image_tasks.h"
#include "app/messages.h"
#include "app/waiting.h"
#include "tools/brush_target.h"

namespace sward {

using namespace bar;

namespace {

constexpr const char *kRound = "round", *kFromFile = "From file...";

void turnWidgets(Rows& rows, BrushSettings& b) {
    const std::vector<std::string> turns{"fixed", "random", "along"};
    int turn = static_cast<int>(b.shapeTurn);
    next(rows, "Turn", em(5.5f));
    caption("Turn");
    ImGui::SetNextItemWidth(em(5.5f));
    if (ui::combo("Turn", turns, turn)) b.shapeTurn = static_cast<ShapeTurn>(turn);
    ui::tooltip(
        "fixed: each stamp by the angle alone. random: each stamp anew. along: its upper edge goes the way of "
        "the stroke.");
    number(rows, "Shape angle", b.shapeAngleDeg, em(5), range(0, 360, -360, 360, "deg"),
           "How far the shape is turned, clockwise seen from above; its upper edge is north (-z) at 0.");
}

}  // namespace

void takeShape(Waiting& waiting, BrushBook& brushes, const std::string& file, WaitedEnd then) {
    waitFor(
        waiting, "Reading " + std::filesystem::path(file).filename().string(),
        [&brushes, file](JobControl&) -> Result<Taking> {
            const Result<ShapePtr> read = loadShape(file);
            if (!read) return read.error();
            return Taking([&brushes, file, shape = *read]() -> Status {
                currentBrush(brushes).shape = shape;
                std::erase(brushes.shapeFiles, file);
                brushes.shapeFiles.insert(brushes.shapeFiles.begin(), file);
                return {};
            });
        },
        std::move(then));
}

void shapeWidgets(Rows& rows, BrushBook& brushes, const ShapeParts& parts) {
    BrushSettings& b = currentBrush(brushes);
    std::vector<std::string> names{kRound}, files{""};
    for (const char* name : builtInShapes()) names.push_back(name), files.push_back("");
    for (const std::string& file : brushes.shapeFiles)
        names.push_back(std::filesystem::path(file).filename().string()), files.push_back(file);
    names.push_back(kFromFile), files.push_back("");
    int chosen = 0;
    for (size_t i = 0; i < names.size() && b.shape; ++i)
        if (files[i] == b.shape->name || (files[i].empty() && names[i] == b.shape->name)) chosen = static_cast<int>(i);
    next(rows, "Shape", em(8));
    caption("Shape");
    ImGui::SetNextItemWidth(em(8));
    if (ui::combo("Shape", names, chosen)) {
        const std::string name = names[static_cast<size_t>(chosen)], file = files[static_cast<size_t>(chosen)];
        if (name == kFromFile)
            requestImage(parts.images, parts.doc, ImageTask::Shape);
        else if (file.empty())
            b.shape = builtInShape(name);
        else
            parts.edits.deferred.push_back([&brushes, &messages = parts.messages, &waiting = parts.waiting, file] {
                takeShape(waiting, brushes, file, [&messages](const Status& taken) { accept(messages, taken); });
            });
    }
    ui::tooltip(
        "What a stamp weighs: round with a falloff, or the light of a grey picture, which fills the square "
        "around the ring. " +
        (b.shape ? "Now: " + b.shape->name : std::string()));
    if (b.shape) turnWidgets(rows, b);
}

void imprintWidgets(Rows& rows, BrushSettings& b) {
    number(rows, "Height", b.value, em(7), range(-20, 20, -1e5, 1e5, "m"),
           "Metres that white lies above black; below 0 it digs.");
    const std::vector<std::string> blends{"add", "maximum", "minimum", "replace"};
    int blend = static_cast<int>(b.blend);
    next(rows, "Blend", em(6.5f));
    caption("Blend");
    ImGui::SetNextItemWidth(em(6.5f));
    if (ui::combo("Blend", blends, blend)) b.blend = static_cast<HeightBlend>(blend);
    ui::tooltip(
        "add: onto the ground. maximum, minimum: the higher, the lower of the ground and the picture. replace: "
        "the picture instead of the ground. All but add stand on the base, and fade by the falloff.");
    if (b.blend == HeightBlend::Add) return;
    next(rows, "From ground", em(2));
    ui::checkbox("From ground", b.fromStart);
    ui::tooltip("Black lies at the height of the ground in the stamp's middle; else at the base beside.");
    const ui::Disabled unused(b.fromStart);
    number(rows, "Base", b.base, em(6), range(-10, 100, -1e5, 1e5, "m"), "The height at which black lies.");
}

void speciesWidgets(Rows& rows, const Document& doc, BrushBook& brushes) {
    const std::vector<std::string> paths = speciesOfField(doc, brushes);
    if (paths.size() < 2) return;
    const size_t count = paintedMaps(doc, brushes).size();
    const std::string label = count == 1 ? "Species" : "Species: " + std::to_string(count);
    next(rows, label.c_str(), em(1));
    if (ui::button("Species", em(7), count > 1)) ImGui::OpenPopup("species");
    ui::tooltip("Which species of the field a stroke paints, all in one undo step: " + std::to_string(count) + " of " +
                std::to_string(paths.size()) + ".");
    if (!ImGui::BeginPopup("species")) return;
    const ui::Scope scope("Species");
    for (const std::string& path : paths) {
        const size_t from = path.find('[') + 1, to = path.find(']');
        bool ticked = path == brushes.map || brushes.species.contains(path);
        const ui::Disabled own(path == brushes.map);
        if (!ui::checkbox(path.substr(from, to - from), ticked)) continue;
        if (ticked)
            brushes.species.insert(path);
        else
            brushes.species.erase(path);
    }
    ImGui::EndPopup();
}

void mirrorWidget(Rows& rows, BrushBook& brushes) {
    const std::vector<std::string> ways{"off", "x", "z", "x and z"};
    int way = (brushes.mirrorX ? 1 : 0) + (brushes.mirrorZ ? 2 : 0);
    next(rows, "Mirror", em(5));
    caption("Mirror");
    ImGui::SetNextItemWidth(em(5));
    if (ui::combo("Mirror", ways, way)) brushes.mirrorX = way % 2 == 1, brushes.mirrorZ = way >= 2;
    ui::tooltip(
        "Strokes of every tool show again on the other side of the terrain's middle: x turns left and right "
        "round, z near and far.");
}

}  // namespace sward
