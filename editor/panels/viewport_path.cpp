#include "panels/viewport_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "model/entity_edits.h"
#include "panels/viewport_input.h"
#include "tools/rings.h"
#include "ui/theme.h"
#include "ui/widgets.h"
#include "world/drawn_project.h"
#include "world/ground.h"

namespace sward {
namespace {

constexpr int kChords = 16;      // of a piece of the curve
constexpr double kOnPoint = 10;  // pixels from a point at which the pointer is on it
constexpr double kOnCurve = 7;   // and from the curve
constexpr double kAbove = 0.03;  // metres at which lines lie over the ground
constexpr ImU32 kInHand = IM_COL32(255, 200, 110, 255), kOther = IM_COL32(225, 225, 215, 150);

ImU32 faded(ImU32 color, double share) {
    return (color & ~IM_COL32_A_MASK) | static_cast<ImU32>(share * static_cast<double>(color >> IM_COL32_A_SHIFT))
                                            << IM_COL32_A_SHIFT;
}

const GroundPath* pathNamed(const ObjectParts& parts, const std::string& entity) {
    const Entity e = parts.doc.isOpen() ? findEntity(parts.doc.project(), entity) : kNoEntity;
    return e == kNoEntity ? nullptr : parts.doc.project().registry.get<GroundPath>(e);
}

const ComponentRow& pathRow(const Document& doc) {
    const auto& rows = doc.tables().components;
    return *std::find_if(rows.begin(), rows.end(), [](const ComponentRow& r) { return isRowOf<GroundPath>(r); });
}

// --- on the screen -----------------------------------------------------------------------------------------------

// What paths lie on and are seen through.
struct PathView {
    const ObjectParts& parts;
    Ground ground;

    glm::dvec3 world(const glm::dvec2& at) const {
        return ground.origin + glm::dvec3(at.x, terrainHeight(*ground.terrain, at.x, at.y) + kAbove, at.y);
    }
    std::optional<glm::dvec2> screen(const glm::dvec2& at) const {
        return projectPoint(parts.camera, parts.view, world(at));
    }
    bool hidden(const glm::dvec2& at) const {
        const HeightAt heights = [this](double x, double z) {
            return ground.origin.y + terrainHeight(*ground.terrain, x - ground.origin.x, z - ground.origin.z);
        };
        return ground.terrain->height.present() && hiddenByGround(heights, parts.camera.eye, world(at), 0.15);
    }
};

// A line on the ground.
void strokeLine(const PathView& v, const std::vector<glm::dvec2>& line, ImU32 color, float width) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    std::optional<glm::dvec2> before;
    for (const glm::dvec2& at : line) {
        const std::optional<glm::dvec2> now = v.screen(at);
        if (now && before) {
            const bool behind = v.hidden(at);
            if (!behind) list.AddLine(vec(*before), vec(*now), faded(IM_COL32(0, 0, 0, 130), 1), width + 2);
            list.AddLine(vec(*before), vec(*now), faded(color, behind ? 0.25 : 1), width);
        }
        before = now;
    }
}

// Beside the curve, to its right where `beside` is above 0; along all of its pieces.
std::vector<glm::dvec2> lineBeside(const GroundCurve& curve, double beside) {
    std::vector<glm::dvec2> out;
    for (const CurvePiece& piece : curve.pieces)
        for (int i = 0; i <= kChords; ++i) {
            const double t = static_cast<double>(i) / kChords;
            const glm::dvec2 way = slopeOn(piece, t);
            const double length = glm::length(way);
            const glm::dvec2 side = length > 0 ? glm::dvec2(-way.y, way.x) / length : glm::dvec2(0);
            out.push_back(placeOn(piece, t) + side * beside);
        }
    return out;
}

// A lone point's edge.
std::vector<glm::dvec2> circle(const glm::dvec2& middle, double radius) {
    std::vector<glm::dvec2> out;
    for (int i = 0; i <= 48; ++i)
        out.push_back(middle + radius * glm::dvec2(std::cos(i * 0.1308996939), std::sin(i * 0.1308996939)));
    return out;
}

void strokePath(const PathView& v, const GroundPath& path, bool inHand) {
    const GroundCurve curve = groundCurve(path);
    if (curve.pieces.empty()) return;
    const double half = 0.5 * static_cast<double>(path.width), reach = reachOf(path);
    const ImU32 color = inHand ? kInHand : kOther;
    const auto& first = curve.pieces.front().bezier;
    const bool spot = curve.pieces.size() == 1 && first[0] == first[3];
    for (const double beside : {reach, half}) {
        const ImU32 ink = faded(color, beside > half ? 0.35 : 0.7);
        if (spot) strokeLine(v, circle(first[0], beside), ink, 1.2f);
        for (const double side : {-beside, beside})
            if (!spot && (beside <= half || reach > half)) strokeLine(v, lineBeside(curve, side), ink, 1.2f);
    }
    if (!spot) strokeLine(v, lineBeside(curve, 0), color, inHand ? 2.4f : 1.6f);
}

void drawPoints(const PathView& v, const GroundPath& path) {
    const PathTool& tool = v.parts.tool.path;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    for (size_t i = 0; i < path.points.size(); ++i) {
        const auto at = v.screen(path.points[i].at);
        if (!at) continue;
        const bool chosen = tool.chosen == i;
        const bool hovered =
            tool.hover && tool.hover->onPoint && tool.hover->entity == tool.entity && tool.hover->point == i;
        const float r = chosen || hovered ? 6.5f : 5;
        list.AddCircleFilled(vec(*at), r + 1.5f, IM_COL32(0, 0, 0, 170));
        list.AddCircleFilled(vec(*at), r, chosen ? IM_COL32(255, 120, 60, 255) : kInHand);
        const ImVec2 c = vec(*at);
        ui::recordAt(fmt::format("Viewport/Point {}", i),
                     {ui::Kind::Area, c.x - r, c.y - r, c.x + r, c.y + r, chosen ? "true" : "false"});
    }
}

// --- under the pointer -------------------------------------------------------------------------------------------

std::optional<PathHover> pointAt(const PathView& v, const std::string& entity, const GroundPath& path,
                                 const glm::dvec2& pointer) {
    std::optional<PathHover> best;
    double least = kOnPoint;
    for (size_t i = 0; i < path.points.size(); ++i) {
        const auto at = v.screen(path.points[i].at);
        const double pixels = at ? glm::length(*at - pointer) : least;
        if (pixels < least) least = pixels, best = {entity, true, i, path.points[i].at};
    }
    return best;
}

std::optional<PathHover> curveAt(const PathView& v, const std::string& entity, const GroundPath& path,
                                 const glm::dvec2& pointer) {
    const GroundCurve curve = groundCurve(path);
    ScreenRing line;
    for (const CurvePiece& piece : curve.pieces)
        for (int i = 0; i < kChords; ++i) line.push_back(v.screen(placeOn(piece, static_cast<double>(i) / kChords)));
    if (line.empty()) return std::nullopt;
    line.push_back(v.screen(curve.pieces.back().bezier[3]));
    line.push_back(std::nullopt);  // the last point does not lead back to the first
    const auto hit = pickRing({&line, 1}, pointer, kOnCurve);
    if (!hit) return std::nullopt;
    const double along = hit->share / kChords;
    const size_t piece = std::min(static_cast<size_t>(along), curve.pieces.size() - 1);
    return PathHover{entity, false, curve.pieces[piece].from,
                     placeOn(curve.pieces[piece], std::clamp(along - static_cast<double>(piece), 0.0, 1.0))};
}

// Points of the path in the hand come first, then curves: its own, then others'.
std::optional<PathHover> pathAt(const ObjectParts& parts, const glm::dvec2& pointer) {
    const PathView v{parts, parts.doc.ground()};
    if (!v.ground.terrain) return std::nullopt;
    const std::string inHand = pathInHand(parts);
    if (const GroundPath* own = pathNamed(parts, inHand)) {
        if (auto hit = pointAt(v, inHand, *own, pointer)) return hit;
        if (auto hit = curveAt(v, inHand, *own, pointer)) return hit;
    }
    const Project& p = parts.doc.visibleProject();
    for (const auto& [name, entity] : p.entities)
        if (const GroundPath* path = p.registry.get<GroundPath>(entity))
            if (auto hit = curveAt(v, name, *path, pointer)) return hit;
    return std::nullopt;
}

// --- edits -------------------------------------------------------------------------------------------------------

// From here on the hand holds the undo step that `label` names.
void hold(const ObjectParts& parts, const std::string& entity, const std::string& label) {
    parts.edits.holding = entity + ".GroundPath";
    parts.doc.beginGroup(label);
}
void letGo(const ObjectParts& parts) {
    parts.edits.holding.clear();
    parts.doc.cancelGroup();
}

void takePoint(const ObjectParts& parts, size_t point, const FrameInput& in, const glm::dvec2& offset) {
    parts.tool.path.chosen = point;
    parts.tool.path.drag = PathDrag{point, {in.x, in.y}, offset};
}

// On the terrain under a place in the window, metres from its corner.
std::optional<glm::dvec2> placeUnder(const ObjectParts& parts, double x, double y) {
    const auto at = groundAt(parts.doc, parts.camera, parts.view, x, y);
    if (!at) return std::nullopt;
    const glm::dvec3 origin = parts.doc.ground().origin;
    return glm::dvec2(at->x - origin.x, at->z - origin.z);
}

Status addPoint(const ObjectParts& parts, const std::string& entity, size_t at, const glm::dvec2& place) {
    const GroundPath& path = *pathNamed(parts, entity);
    if (path.points.size() >= kMostPathPoints)
        return usage(fmt::format("{} has {} points, and no path has more", entity, path.points.size()),
                     "remove some, or begin another path: Shift+P");
    const GroundPath more = withPoint(path, at, place);
    return parts.doc.assignComponent(entity, pathRow(parts.doc), &more);
}

// A path of one point; its name, or nothing and it is said why.
std::optional<std::string> newPath(const ObjectParts& parts, const glm::dvec2& place) {
    const std::string name = freeName(parts.doc.project(), "path");
    hold(parts, name, "draw " + name);
    GroundPath path;
    path = withPoint(path, 0, place);
    const bool done = accept(parts.messages, parts.doc.addEntity(name)) &&
                      accept(parts.messages, parts.doc.assignComponent(name, pathRow(parts.doc), &path));
    if (!done) return letGo(parts), std::nullopt;
    choose(parts.selection, name);
    for (const std::string& map : mapsBeyondPaths(parts.doc.project(), parts.doc.tables().components))
        showError(parts.messages, failed(beyondPaths(map)));
    parts.tool.path = {name, 0, std::nullopt, std::nullopt};
    return name;
}

// A click on the ground.
bool addOnGround(const ObjectParts& parts, const FrameInput& in) {
    const auto place = placeUnder(parts, in.x, in.y);
    if (!place) return say(parts.messages, "there is no terrain: a path's points lie on it"), false;
    const std::string entity = pathInHand(parts);
    if (entity.empty()) {
        if (!newPath(parts, *place)) return false;
        takePoint(parts, 0, in, {0, 0});
        return true;
    }
    const size_t at = nextPoint(*pathNamed(parts, entity), parts.tool.path.chosen);
    hold(parts, entity, "add a point to " + entity);
    if (!accept(parts.messages, addPoint(parts, entity, at, *place))) return letGo(parts), false;
    takePoint(parts, at, in, {0, 0});
    return true;
}

}  // namespace

bool drawsPaths(const ObjectParts& parts) {
    return parts.active && parts.tool.mode == GizmoMode::Path && parts.tool.placing.empty();
}

std::string pathInHand(const ObjectParts& parts) {
    const std::string& entity = shownEntity(parts.selection);
    return pathNamed(parts, entity) ? entity : "";
}

void hoverPath(const ObjectParts& parts, const FrameInput& in, bool free) {
    PathTool& tool = parts.tool.path;
    tool.hover.reset();
    if (!parts.active) return;
    const std::string entity = pathInHand(parts);
    const GroundPath* path = pathNamed(parts, entity);
    if (std::exchange(tool.entity, entity) != entity || !path || tool.chosen >= path->points.size())
        tool.chosen.reset();  // undone, or another path is chosen
    if (free && drawsPaths(parts)) tool.hover = pathAt(parts, {in.x, in.y});
}

void drawPaths(const ObjectParts& parts) {
    if (!parts.active || !parts.doc.isOpen()) return;
    const PathView v{parts, parts.doc.ground()};
    if (!v.ground.terrain) return;
    const std::string inHand = pathInHand(parts);
    const Project& p = parts.doc.visibleProject();
    for (const auto& [name, entity] : p.entities)
        if (const GroundPath* path = p.registry.get<GroundPath>(entity); path && name != inHand && drawsPaths(parts))
            strokePath(v, *path, false);
    const GroundPath* own = pathNamed(parts, inHand);
    if (!own) return;
    strokePath(v, *own, true);
    if (drawsPaths(parts)) drawPoints(v, *own);
}

bool grabPath(const ObjectParts& parts, const FrameInput& in) {
    const std::optional<PathHover> hit = pathAt(parts, {in.x, in.y});
    if (!hit) return addOnGround(parts, in);
    if (hit->entity != pathInHand(parts)) return choose(parts.selection, hit->entity), false;
    const PathView v{parts, parts.doc.ground()};
    const glm::dvec2 offset = v.screen(hit->at).value_or(glm::dvec2(in.x, in.y)) - glm::dvec2(in.x, in.y);
    if (hit->onPoint) {
        hold(parts, hit->entity, fmt::format("move point {} of {}", hit->point, hit->entity));
        takePoint(parts, hit->point, in, offset);
        return true;
    }
    hold(parts, hit->entity, "add a point to " + hit->entity);
    if (!accept(parts.messages, addPoint(parts, hit->entity, hit->point + 1, hit->at))) return letGo(parts), false;
    takePoint(parts, hit->point + 1, in, offset);
    return true;
}

void dragPath(const ObjectParts& parts, double x, double y) {
    std::optional<PathDrag>& drag = parts.tool.path.drag;
    if (!drag || (!drag->moved && glm::length(glm::dvec2(x, y) - drag->from) < kFirstMotion)) return;
    drag->moved = true;
    const std::string entity = pathInHand(parts);
    const auto place = placeUnder(parts, x + drag->offset.x, y + drag->offset.y);
    const GroundPath* path = pathNamed(parts, entity);
    if (!place || !path || drag->point >= path->points.size()) return;
    GroundPath moved = *path;
    moved.points[drag->point].at = roundedPlace(*place);
    if (!(moved == *path) && !accept(parts.messages, parts.doc.assignComponent(entity, pathRow(parts.doc), &moved)))
        drag.reset();
}

void releasePath(const ObjectParts& parts) { parts.tool.path.drag.reset(); }

void cancelPath(const ObjectParts& parts) {
    parts.tool.path.drag.reset();
    if (parts.edits.holding.empty()) return;
    letGo(parts);
    say(parts.messages, "the path is as it was");
}

bool removePathPoint(const ObjectParts& parts) {
    PathTool& tool = parts.tool.path;
    const std::string entity = pathInHand(parts);
    const GroundPath* path = pathNamed(parts, entity);
    if (!drawsPaths(parts) || !path || tool.entity != entity || !tool.chosen || *tool.chosen >= path->points.size())
        return false;
    const size_t removed = *tool.chosen;
    const GroundPath left = withoutPoint(*path, removed);
    parts.doc.beginGroup(fmt::format("remove point {} of {}", removed, entity));
    const bool done = accept(parts.messages, parts.doc.assignComponent(entity, pathRow(parts.doc), &left));
    parts.doc.endGroup();
    if (done) tool.chosen = chosenAfterRemoval(left, removed);
    if (done && left.points.empty())
        say(parts.messages, entity + " has no points left: click on the ground, or Delete removes it");
    return true;
}

void beginPath(const ObjectParts& parts) {
    const Rect& r = parts.view;
    const auto place = placeUnder(parts, static_cast<double>(r.x + r.w / 2), static_cast<double>(r.y + r.h / 2));
    if (!place)
        return say(parts.messages, "the middle of the view shows no terrain: look at where the path is to begin");
    const std::optional<std::string> name = newPath(parts, *place);
    parts.edits.holding.clear();
    if (!name) return;
    parts.doc.endGroup();
    say(parts.messages, *name + " begins here: click on the ground where it goes on, Enter ends");
}

void endPath(const ObjectParts& parts) {
    parts.tool.mode = GizmoMode::Select;
    parts.tool.path.chosen.reset();
    const std::string entity = pathInHand(parts);
    if (!entity.empty()) say(parts.messages, entity + " is drawn; its width and effect stand in the inspector");
}

}  // namespace sward
