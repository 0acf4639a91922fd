#include "panels/viewport_place.h"

#include <fmt/format.h>

#include <cmath>

#include "core/json.h"
#include "model/entity_edits.h"
#include "panels/viewport_input.h"

namespace sward {
namespace {

// Whole degrees that differ from name to name: the same clicks give the same scene.
int turnFor(const std::string& name) {
    uint32_t h = 2166136261u;  // FNV-1a
    for (const char c : name) h = (h ^ static_cast<unsigned char>(c)) * 16777619u;
    return static_cast<int>((h >> 8) % 360) - 180;
}

Status addObject(Document& doc, const std::string& name, const std::string& file, const glm::dvec3& at, int turnDeg) {
    if (Status s = doc.addEntity(name); !s) return s;
    if (Status s = doc.addComponent(name, "Transform"); !s) return s;
    if (Status s = doc.addComponent(name, "StaticMesh"); !s) return s;
    const auto millimetres = [](double metres) { return shortestText(std::round(metres * 1e3) / 1e3); };
    const std::string place = fmt::format("[{}, 0, {}]", millimetres(at.x), millimetres(at.z));
    if (Status s = doc.setField(name + ".Transform.position", place); !s) return s;
    if (Status s = doc.setField(name + ".StaticMesh.rotationDeg", fmt::format("[0, {}, 0]", turnDeg)); !s) return s;
    return doc.setField(name + ".StaticMesh.file", file);
}

}  // namespace

bool placeObject(const ObjectParts& parts, double x, double y) {
    const auto at = groundAt(parts.doc, parts.camera, parts.view, x, y);
    if (!at) return false;
    const std::string& file = parts.tool.placing;
    const std::string name = freeName(parts.doc.project(), std::filesystem::path(file).stem().string());
    parts.doc.beginGroup("place " + name);
    const int turn = parts.tool.randomTurn ? turnFor(name) : 0;
    const bool done = accept(parts.messages, addObject(parts.doc, name, file, *at, turn));
    if (!done) parts.doc.cancelGroup();
    if (!done) return true;
    parts.doc.endGroup();
    choose(parts.selection, name);
    say(parts.messages, "placed " + name + "; Escape ends placing");
    return true;
}

void drawPlacing(const ObjectParts& parts, const std::optional<glm::dvec3>& ground) {
    if (!parts.active || parts.tool.placing.empty() || !ground) return;
    if (const auto corners = parts.tool.objects.cornersAt(parts.doc.project(), parts.tool.placing, *ground))
        drawBox(parts, *corners, IM_COL32(150, 220, 255, 255));
}

}  // namespace sward
