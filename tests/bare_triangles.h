// The triangles that stand for a field's blades: posed as the truth poses them, as many quads as their length on screen
// asks, in clip space; and which of them can show anything with one sample a pixel. For benchmarks and tests: neither
// shares code with what draws them. Does not: draw.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <vector>

#include "core/numerics.h"
#include "frame/renderer.h"
#include "grass/grown.h"
#include "reference/standing.h"
#include "scene/technique.h"
#include "techniques.h"
#include "tests/fields.h"
#include "world/ground.h"

namespace sward::test {

constexpr float kNear = 0.05f;  // metres
constexpr float kPixelsPerQuad = 16;

enum Share { kAll, kBoxes, kExact, kShares };
using ClipCorners = std::array<glm::vec4, 3>;  // in clip space

struct BareTriangles {
    size_t blades = 0,
           inView = 0;  // of the field; those with a triangle that the frustum may hold: others are in no list
    std::array<std::vector<ClipCorners>, kShares> of;
};

// Pixels from the lower left.
inline glm::dvec2 onScreen(const glm::vec4& p, const glm::ivec2& size) {
    const glm::dvec2 at(p.x / p.w, p.y / p.w);
    return (at + 1.0) * 0.5 * glm::dvec2(size);
}
inline bool outside(const ClipCorners& t) {
    const auto all = [&](auto beyond) { return std::all_of(t.begin(), t.end(), beyond); };
    return all([](const glm::vec4& p) { return p.x < -p.w; }) || all([](const glm::vec4& p) { return p.x > p.w; }) ||
           all([](const glm::vec4& p) { return p.y < -p.w; }) || all([](const glm::vec4& p) { return p.y > p.w; }) ||
           all([](const glm::vec4& p) { return p.w < kNear; });
}
inline double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}
// The narrowest of the shares that it belongs to. A sample lies in the middle of a pixel.
inline Share narrowest(const ClipCorners& t, const glm::ivec2& size) {
    if (std::any_of(t.begin(), t.end(), [](const glm::vec4& p) { return p.w < kNear; })) return kExact;
    const glm::dvec2 p[3] = {onScreen(t[0], size), onScreen(t[1], size), onScreen(t[2], size)};
    const glm::dvec2 low = glm::min(p[0], glm::min(p[1], p[2])), high = glm::max(p[0], glm::max(p[1], p[2]));
    const glm::dvec2 first = glm::max(glm::ceil(low - 0.5), glm::dvec2(0)),
                     last = glm::min(glm::floor(high - 0.5), glm::dvec2(size.x - 1, size.y - 1));
    if (first.x > last.x || first.y > last.y) return kAll;
    for (double y = first.y; y <= last.y; ++y)
        for (double x = first.x; x <= last.x; ++x) {
            const glm::dvec2 at(x + 0.5, y + 0.5);
            const double a = turn(p[0], p[1], at), b = turn(p[1], p[2], at), c = turn(p[2], p[0], at);
            if ((a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0)) return kExact;
        }
    return kBoxes;
}
inline void add(BareTriangles& out, const ClipCorners& t, const glm::ivec2& size, bool& seen) {
    if (outside(t)) return;
    seen = true;
    const Share s = narrowest(t, size);
    for (int share = kAll; share <= s; ++share) out.of[static_cast<size_t>(share)].push_back(t);
}

// A blade is as wide as its image covers in the mean: a pointed ribbon covers half of its strip.
struct Shape {
    int mostQuads = 1;
    float width = 1;  // factor
};
inline Shape shapeOf(const Project& p, const FieldEntity& field, const Species& s) {
    const Rgba8 image = bladeImage(p, s);
    double sum = 0;
    for (size_t i = 3; i < image.pixels.size(); i += 4) sum += image.pixels[i];
    const bool tessellated = field.grows.technique == nameOf(Technique::Tessellated);
    return {tessellated ? s.smoothness : s.segments,
            static_cast<float>(2 * sum / (255.0 * static_cast<double>(image.pixels.size() / 4)))};
}
// All, half or one: as many levels as other programs have.
inline int quadsOf(const glm::vec4& root, const glm::vec4& tip, const glm::ivec2& size, int most) {
    const int level =
        f32::tessLevelOnScreen(root, tip, glm::vec2(size), kNear, kPixelsPerQuad, static_cast<float>(most));
    return level > most / 2 ? most : level > 1 ? (most + 1) / 2 : 1;
}
inline void addBlade(BareTriangles& out, const Posed& b, const glm::vec3& corner, const Shape& shape,
                     const glm::mat4& view, const glm::ivec2& size) {
    ++out.blades;
    const glm::vec3 root = corner + b.root,
                    side = glm::vec3(-b.facing.y, 0, b.facing.x) * (0.5f * b.width * shape.width);
    const auto at = [&](float v, float across) {
        const glm::vec3 curve = 2 * v * (1 - v) * b.control + v * v * b.tip;
        return view * glm::vec4(root + curve + across * (1 - v) * side, 1);
    };
    const int quads = quadsOf(at(0, 0), at(1, 0), size, shape.mostQuads);
    bool seen = false;
    for (int i = 0; i < quads; ++i) {
        const float low = static_cast<float>(i) / static_cast<float>(quads),
                    high = static_cast<float>(i + 1) / static_cast<float>(quads);
        add(out, {at(low, -1), at(low, 1), at(high, i + 1 < quads ? 1 : 0)}, size, seen);
        if (i + 1 < quads) add(out, {at(low, -1), at(high, 1), at(high, -1)}, size, seen);
    }
    out.inView += seen;
}
// A software rasteriser takes a slow way with runs of vertices of which one is to be clipped: those come last.
inline void orderForRuns(std::vector<ClipCorners>& all) {
    const auto within = [](const glm::vec4& p) { return p.w > kNear && std::abs(p.x) < p.w && std::abs(p.y) < p.w; };
    std::stable_partition(all.begin(), all.end(),
                          [&](const ClipCorners& t) { return std::all_of(t.begin(), t.end(), within); });
}
inline BareTriangles bareTriangles(const Project& p, const ViewCamera& camera, const glm::ivec2& size, double time) {
    BareTriangles out;
    JobControl control;
    const auto species = standingBlades(p, time, {}, SIZE_MAX, control);
    if (!species) return out;
    const glm::mat4 view = viewProjection(camera, size.x, size.y);
    const glm::dvec3 origin = findGround(p).origin;
    for (const auto& [name, field] : fieldsOf(p))
        for (const StandingSpecies& s : *species) {
            if (s.field != name) continue;
            const Shape shape = shapeOf(p, field, *s.species);
            for (const StandingCell& c : s.cells)
                for (const Posed& b : c.blades)
                    addBlade(out, b, glm::vec3(origin + c.corner - camera.eye), shape, view, size);
        }
    for (auto& triangles : out.of) orderForRuns(triangles);
    return out;
}

}  // namespace sward::test
