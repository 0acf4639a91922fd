#include "mesh/facing.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace sward {
namespace {

constexpr int kNormalTurns = 32;  // of a normal about the upright

// Pieces: each vertex points to the least that it hangs together with.
struct Pieces {
    std::vector<uint32_t> up;

    explicit Pieces(const Mesh& mesh) : up(mesh.vertices.size()) {
        std::iota(up.begin(), up.end(), 0u);
        joinSamePlaces(mesh);
        for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
            for (size_t k = 1; k < 3; ++k) join(mesh.indices[i], mesh.indices[i + k]);
    }
    uint32_t of(uint32_t v) {
        while (up[v] != v) v = up[v] = up[up[v]];
        return v;
    }
    void join(uint32_t a, uint32_t b) {
        a = of(a), b = of(b);
        up[std::max(a, b)] = std::min(a, b);
    }
    // Files have a vertex for each normal at an edge.
    void joinSamePlaces(const Mesh& mesh) {
        std::vector<uint32_t> order(mesh.vertices.size());
        std::iota(order.begin(), order.end(), 0u);
        const auto place = [&](uint32_t v) {
            const glm::vec3& p = mesh.vertices[v].position;
            return std::array{p.x, p.y, p.z};
        };
        std::sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) { return place(a) < place(b); });
        for (size_t i = 1; i < order.size(); ++i)
            if (place(order[i - 1]) == place(order[i])) join(order[i - 1], order[i]);
    }
};

// Half the cross product: as long as the triangle's area.
glm::dvec3 areaNormal(const Mesh& mesh, size_t first) {
    const auto at = [&](size_t k) { return glm::dvec3(mesh.vertices[mesh.indices[first + k]].position); };
    return 0.5 * glm::cross(at(1) - at(0), at(2) - at(0));
}

// Calls body(weight, dot with the eye, dot with the light) for normals of all bins, about the upright.
template <class F>
void eachNormal(const Facing& facing, const glm::vec3& light, const glm::vec3& eye, F body) {
    for (int b = 0; b < kFacingBins; ++b) {
        if (!(facing[static_cast<size_t>(b)] > 0)) continue;
        const float y = (static_cast<float>(b) + 0.5f) / kFacingBins, r = std::sqrt(1 - y * y);
        for (int k = 0; k < kNormalTurns; ++k) {
            const float turn = kFullTurn * (static_cast<float>(k) + 0.5f) / kNormalTurns;
            const glm::vec3 n(r * std::cos(turn), y, r * std::sin(turn));
            body(facing[static_cast<size_t>(b)], n, glm::dot(n, eye), glm::dot(n, light));
        }
    }
}
glm::vec3 rising(float y) { return {std::sqrt(std::max(1 - y * y, 0.0f)), y, 0}; }

// Light on the sides that are seen (1) or on those that are not (-1), as a share of what faces it.
float litOn(float side, const Facing& facing, float light, float eye, float cosine) {
    const glm::vec3 e = rising(eye);
    glm::vec3 l(0, light, 0);
    l.x = e.x > 1e-6f ? std::clamp((cosine - light * eye) / e.x, -1.0f, 1.0f) : 0;
    l.z = std::sqrt(std::max(1 - l.x * l.x - l.y * l.y, 0.0f));
    float sent = 0, all = 0;
    eachNormal(facing, l, e, [&](float weight, const glm::vec3&, float seen, float lit) {
        all += weight * std::abs(seen);
        if (side * seen * lit > 0) sent += weight * std::abs(seen * lit);
    });
    return all > 0 ? sent / all : 0;
}

// Areas of triangles first to end that count, and those of leaves among them.
glm::dvec2 leafArea(const Mesh& mesh, const std::vector<float>& shares, size_t first, size_t end) {
    glm::dvec2 sum(0);
    for (size_t i = first; i + 2 < end; i += 3) {
        const double area = glm::length(areaNormal(mesh, i)), counts = static_cast<double>(shares[i / 3]);
        sum += area * glm::dvec2(counts, std::max(2 * counts - 1, 0.0));
    }
    return sum;
}
float leafShare(const glm::dvec2& area) { return area.x > 0 ? static_cast<float>(area.y / area.x) : 0; }

}  // namespace

std::vector<float> leafShares(const Mesh& mesh) {
    struct Sum {
        double area = 0;
        glm::dvec3 normal{0};
    };
    Pieces pieces(mesh);
    std::vector<Sum> sums(mesh.vertices.size());
    for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        Sum& s = sums[pieces.of(mesh.indices[i])];
        const glm::dvec3 n = areaNormal(mesh, i);
        s.area += glm::length(n), s.normal += n;
    }
    std::vector<float> out;
    for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const Sum& s = sums[pieces.of(mesh.indices[i])];
        const double open = s.area > 0 ? std::min(glm::length(s.normal) / s.area, 1.0) : 1;
        out.push_back(static_cast<float>(0.5 * (1 + open)));
    }
    return out;
}

std::vector<float> leafParts(const Mesh& mesh) {
    const std::vector<float> shares = leafShares(mesh);
    std::vector<float> out;
    for (const MeshPart& p : mesh.parts) out.push_back(leafShare(leafArea(mesh, shares, p.first, p.first + p.count)));
    return out;
}
float leafPart(const Mesh& mesh) { return leafShare(leafArea(mesh, leafShares(mesh), 0, mesh.indices.size())); }

Facing evenFacing() {
    Facing f;
    f.fill(1.0f / kFacingBins);
    return f;
}

Facing facingOf(const Mesh& mesh) {
    const std::vector<float> shares = leafShares(mesh);
    std::array<double, kFacingBins> sums{};
    double all = 0;
    for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const glm::dvec3 n = areaNormal(mesh, i);
        const double area = glm::length(n);
        if (!(area > 0)) continue;
        const double counts = area * static_cast<double>(shares[i / 3]);
        sums[static_cast<size_t>(std::min(static_cast<int>(std::abs(n.y) / area * kFacingBins), kFacingBins - 1))] +=
            counts;
        all += counts;
    }
    if (!(all > 0)) return evenFacing();
    Facing f;
    for (size_t b = 0; b < f.size(); ++b) f[b] = static_cast<float>(sums[b] / all);
    return f;
}

float seenFrom(const Facing& facing, float y) {
    float sum = 0;
    eachNormal(facing, glm::vec3(0), rising(y),
               [&](float weight, const glm::vec3&, float seen, float) { sum += weight * std::abs(seen); });
    return 2 * sum / kNormalTurns;
}

float sentTo(const Facing& facing, float light, float eye, float cosine) {
    return litOn(1, facing, light, eye, cosine);
}
float passedTo(const Facing& facing, float light, float eye, float cosine) {
    return litOn(-1, facing, light, eye, cosine);
}

float seenRise(const Facing& facing, float eye) {
    float sum = 0, all = 0;
    eachNormal(facing, glm::vec3(0), rising(eye), [&](float weight, const glm::vec3& n, float seen, float) {
        all += weight * std::abs(seen);
        sum += weight * std::abs(seen) * (seen < 0 ? -n.y : n.y);
    });
    return all > 0 ? sum / all : 0;
}

}  // namespace sward
