// The outline of what stands on the ground: cover · distances · reading.
#include "mesh/footprint.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "maps/distances.h"

namespace sward {
namespace {

// What of a triangle lies at y <= top: up to four corners, x and z.
struct Corners {
    std::array<glm::vec2, 4> at;
    size_t count = 0;
};
Corners cutAbove(const glm::vec3 (&p)[3], float top) {
    Corners out;
    for (size_t i = 0; i < 3; ++i) {
        const glm::vec3 &a = p[i], &b = p[(i + 1) % 3];
        if (a.y <= top) out.at[out.count++] = {a.x, a.z};
        if ((a.y <= top) == (b.y <= top)) continue;
        const glm::vec3 cut = a + (b - a) * ((top - a.y) / (b.y - a.y));
        out.at[out.count++] = {cut.x, cut.z};
    }
    return out;
}

std::vector<Corners> lowParts(const Mesh& mesh, const glm::mat3& turn, float top) {
    std::vector<Corners> out;
    for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        glm::vec3 p[3];
        bool sound = true;
        for (size_t k = 0; k < 3; ++k) {
            p[k] = turn * mesh.vertices[mesh.indices[i + k]].position;
            sound = sound && std::isfinite(p[k].x + p[k].y + p[k].z);
        }
        const Corners corners = sound ? cutAbove(p, top) : Corners{};
        if (corners.count > 0) out.push_back(corners);
    }
    return out;
}

// The raster, the outline in its middle half.
void place(Footprint& f, const std::vector<Corners>& parts) {
    glm::vec2 low(INFINITY), high(-INFINITY);
    for (const Corners& c : parts)
        for (size_t i = 0; i < c.count; ++i)
            low = glm::min(low, c.at[i]), high = glm::max(high, c.at[i]),
            f.farthest = std::max(f.farthest, glm::length(c.at[i]));
    const glm::vec2 size = high - low;
    const float longer = std::max({size.x, size.y, 1e-3f});
    f.texel = 2 * longer / kFootprintSide;
    f.farthest += 1.5f * f.texel;
    const auto texels = [&](float metres) { return static_cast<int>(std::ceil((metres + longer) / f.texel)); };
    f.width = texels(size.x), f.height = texels(size.y);
    f.low = (low + high) * 0.5f - 0.5f * f.texel * glm::vec2(f.width, f.height);
}

// Marks texels whose centres lie in a convex part, and those that its edges cross.
void cover(const Footprint& f, const Corners& c, std::vector<uint8_t>& covered) {
    std::array<glm::vec2, 4> p;
    for (size_t i = 0; i < c.count; ++i) p[i] = (c.at[i] - f.low) / f.texel;
    const auto mark = [&](int x, int y) {
        if (x >= 0 && y >= 0 && x < f.width && y < f.height)
            covered[static_cast<size_t>(y) * static_cast<size_t>(f.width) + static_cast<size_t>(x)] = 1;
    };
    float top = INFINITY, bottom = -INFINITY;
    for (size_t i = 0; i < c.count; ++i) {
        const glm::vec2 a = p[i], way = p[(i + 1) % c.count] - a;
        const int steps = 1 + static_cast<int>(2 * glm::length(way));
        for (int s = 0; s <= steps; ++s) {
            const glm::vec2 at = a + way * (static_cast<float>(s) / static_cast<float>(steps));
            mark(static_cast<int>(std::floor(at.x)), static_cast<int>(std::floor(at.y)));
        }
        top = std::min(top, a.y), bottom = std::max(bottom, a.y);
    }
    for (int y = std::max(static_cast<int>(top), 0); y <= std::min(static_cast<int>(bottom), f.height - 1); ++y) {
        const float middle = static_cast<float>(y) + 0.5f;
        float left = INFINITY, right = -INFINITY;
        for (size_t i = 0; i < c.count; ++i) {
            const glm::vec2 a = p[i], b = p[(i + 1) % c.count];
            if ((a.y <= middle) == (b.y <= middle)) continue;
            const float x = a.x + (b.x - a.x) * (middle - a.y) / (b.y - a.y);
            left = std::min(left, x), right = std::max(right, x);
        }
        for (int x = std::max(static_cast<int>(std::ceil(left - 0.5f)), 0);
             left <= right && x <= std::min(static_cast<int>(std::floor(right - 0.5f)), f.width - 1); ++x)
            mark(x, y);
    }
}

float bilinear(const Footprint& f, const glm::vec2& place) {
    const glm::vec2 at =
        glm::clamp((place - f.low) / f.texel - 0.5f, glm::vec2(0), glm::vec2(f.width - 1, f.height - 1));
    const int x = std::min(static_cast<int>(at.x), f.width - 2), y = std::min(static_cast<int>(at.y), f.height - 2);
    const float *row = &f.distances[static_cast<size_t>(y) * static_cast<size_t>(f.width) + static_cast<size_t>(x)],
                *next = row + f.width;
    const glm::vec2 part = at - glm::vec2(x, y);
    return glm::mix(glm::mix(row[0], row[1], part.x), glm::mix(next[0], next[1], part.x), part.y);
}

}  // namespace

Footprint makeFootprint(const Mesh& mesh, const glm::mat3& turn, float top) {
    Footprint f;
    const std::vector<Corners> parts = lowParts(mesh, turn, top);
    if (parts.empty()) return f;
    place(f, parts);
    std::vector<uint8_t> covered(static_cast<size_t>(f.width) * static_cast<size_t>(f.height));
    for (const Corners& c : parts) cover(f, c, covered);
    f.distances = distancesTo(covered, f.width, f.height, 1);
    const std::vector<float> depth = distancesTo(covered, f.width, f.height, 0);
    for (size_t i = 0; i < depth.size(); ++i)
        f.distances[i] = f.texel * (covered[i] ? 0.5f - depth[i] : f.distances[i] - 0.5f);
    return f;
}

glm::vec3 outlineAt(const Footprint& f, const glm::vec2& place) {
    const glm::vec2 x(f.texel, 0), y(0, f.texel), beside = place - glm::clamp(place, f.low, f.high());
    const glm::vec2 slope(bilinear(f, place + x) - bilinear(f, place - x),
                          bilinear(f, place + y) - bilinear(f, place - y));
    const float far = glm::length(beside);
    return {bilinear(f, place) + far, far > 0 ? beside / far : slope / (2 * f.texel)};
}

}  // namespace sward
