#include "app/path_actions.h"

#include <fmt/format.h>

#include <algorithm>

#include "playtest/playtest.h"
#include "tools/camera_control.h"
#include "world/camera_path.h"
#include "world/view_camera.h"

namespace sward {
namespace {

const GroundPath* pathOf(const Project& p, const std::string& entity) {
    const Entity e = findEntity(p, entity);
    return e == kNoEntity ? nullptr : p.registry.get<GroundPath>(e);
}

CameraPath cameraAlong(const Project& p, const std::string& entity) {
    return cameraAlong(*pathOf(p, entity), findGround(p), kEyeHeight, kWalkSpeed);
}

}  // namespace

std::string pathMeant(const Document& doc, const Selection& selection) {
    if (!doc.isOpen()) return "";
    if (pathOf(doc.project(), shownEntity(selection))) return shownEntity(selection);
    for (const auto& [name, e] : doc.project().entities)
        if (doc.project().registry.get<GroundPath>(e)) return name;
    return "";
}

void cameraFromPath(Document& doc, const Selection& selection, Messages& messages) {
    const std::string entity = pathMeant(doc, selection);
    if (entity.empty()) return say(messages, "there is no path: draw one with the path tool (P)");
    const CameraPath way = cameraAlong(doc.standing(), entity);
    if (way.keys.empty())
        return showError(messages, failed(entity + ".GroundPath leads nowhere", "give it two points that lie apart"));
    const auto& rows = doc.tables().components;
    const auto row =
        std::find_if(rows.begin(), rows.end(), [](const ComponentRow& r) { return isRowOf<CameraPath>(r); });
    doc.beginGroup("camera path along " + entity);
    const bool done = accept(messages, doc.assignComponent(entity, *row, &way));
    doc.endGroup();
    if (done)
        say(messages, fmt::format("{}.CameraPath has {} keys, {:.0f} s of walking: render --path {}", entity,
                                  way.keys.size(), secondsOf(way), entity));
}

void walkPath(const PlayParts& parts, const Selection& selection, const FlyCamera& view, ViewportHand& hand,
              const Edits& edits, bool typing) {
    const std::string entity = pathMeant(parts.doc, selection);
    if (entity.empty()) return say(parts.messages, "there is no path: draw one with the path tool (P)");
    if (!playing(parts.doc)) {
        const CameraPath way = cameraAlong(parts.doc.standing(), entity);
        FlyCamera from = view;
        if (!way.keys.empty()) {
            ViewCamera first = viewOf(view);
            first.eye = way.keys.front().eye, first.target = way.keys.front().target;
            from = flyFrom(first);
        }
        togglePlay(parts, from, hand, edits, typing);
    }
    if (Playtest* play = parts.doc.play(); play && accept(parts.messages, play->walkAlong(entity)))
        say(parts.messages, "walking along " + entity + "; W A S D takes over, F5 stops");
}

}  // namespace sward
