#include "reference/vertex_fit.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "core/hash.h"
#include "core/numerics.h"

namespace sward {
namespace {

constexpr int kSteps = 60;        // of conjugate gradients
constexpr float kSmooth = 0.05f;  // what an edge counts, in points

const MeshVertex& cornerOf(const Mesh& m, uint32_t triangle, size_t k) { return m.vertices[m.indices[triangle + k]]; }
double triangleArea(const Mesh& m, uint32_t triangle) {
    const glm::dvec3 a(cornerOf(m, triangle, 0).position), b(cornerOf(m, triangle, 1).position),
        c(cornerOf(m, triangle, 2).position);
    return 0.5 * glm::length(glm::cross(b - a, c - a));
}

struct PlaceHash {
    size_t operator()(const std::pair<glm::vec3, glm::vec3>& p) const { return hashBytes(&p, sizeof(p)); }
};
// Numbers of places by vertex; how many there are comes last.
std::vector<uint32_t> placesOf(const Mesh& mesh) {
    std::unordered_map<std::pair<glm::vec3, glm::vec3>, uint32_t, PlaceHash> known;
    std::vector<uint32_t> out;
    for (const MeshVertex& v : mesh.vertices)
        out.push_back(
            known.try_emplace({v.position + 0.0f, v.normal + 0.0f}, static_cast<uint32_t>(known.size())).first->second);
    out.push_back(static_cast<uint32_t>(known.size()));
    return out;
}

using FittedRows = std::vector<FittedRow>;
void addTimes(FittedRow& to, float factor, const FittedRow& row) {
    for (size_t c = 0; c < row.size(); ++c) to[c] += factor * row[c];
}

// The normal equations: a row of unknowns a place.
struct Equations {
    const Mesh& mesh;
    std::span<const SurfacePoint> points;
    std::vector<uint32_t> place;                       // by vertex
    std::vector<std::pair<uint32_t, uint32_t>> edges;  // of places

    uint32_t placeOf(const SurfacePoint& p, int k) const {
        return place[mesh.indices[p.triangle + static_cast<uint32_t>(k)]];
    }
    FittedRows times(const FittedRows& x) const {
        FittedRows out(x.size(), FittedRow{});
        for (const SurfacePoint& p : points) {
            FittedRow here{};
            for (int k = 0; k < 3; ++k) addTimes(here, p.counts * p.weights[k], x[placeOf(p, k)]);
            for (int k = 0; k < 3; ++k) addTimes(out[placeOf(p, k)], p.weights[k], here);
        }
        for (const auto& [a, b] : edges)
            for (size_t c = 0; c < FittedRow{}.size(); ++c) {
                const float off = kSmooth * (x[a][c] - x[b][c]);
                out[a][c] += off, out[b][c] -= off;
            }
        return out;
    }
};

// Sums over all rows, a column each.
std::array<double, std::tuple_size_v<FittedRow>> dots(const FittedRows& a, const FittedRows& b) {
    std::array<double, std::tuple_size_v<FittedRow>> sum{};
    for (size_t i = 0; i < a.size(); ++i)
        for (size_t c = 0; c < sum.size(); ++c) sum[c] += static_cast<double>(a[i][c]) * static_cast<double>(b[i][c]);
    return sum;
}

// By conjugate gradients, each column by itself.
FittedRows solve(const Equations& e, const FittedRows& right) {
    FittedRows x(right.size(), FittedRow{}), rest = right, way = right;
    auto length = dots(rest, rest);
    for (int step = 0; step < kSteps; ++step) {
        const FittedRows moved = e.times(way);
        const auto along = dots(way, moved);
        for (size_t c = 0; c < length.size(); ++c) {
            const float far = along[c] > 1e-30 ? static_cast<float>(length[c] / along[c]) : 0;
            for (size_t i = 0; i < x.size(); ++i) x[i][c] += far * way[i][c], rest[i][c] -= far * moved[i][c];
        }
        const auto left = dots(rest, rest);
        for (size_t c = 0; c < length.size(); ++c) {
            const float keep = length[c] > 1e-30 ? static_cast<float>(left[c] / length[c]) : 0;
            for (size_t i = 0; i < x.size(); ++i) way[i][c] = rest[i][c] + keep * way[i][c];
        }
        length = left;
    }
    return x;
}

}  // namespace

double surfaceArea(const Mesh& mesh) {
    double sum = 0;
    for (uint32_t i = 0; i + 2 < mesh.indices.size(); i += 3) sum += triangleArea(mesh, i);
    return sum;
}

std::vector<SurfacePoint> pointsOver(const Mesh& mesh, size_t count, uint32_t seed) {
    const double all = surfaceArea(mesh);
    std::vector<SurfacePoint> out;
    if (!(all > 0)) return out;
    double before = 0;
    for (uint32_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        before += triangleArea(mesh, i);
        // The points lie at equal steps of the area, from half a step on.
        while (out.size() < count &&
               (static_cast<double>(out.size()) + 0.5) * all < before * static_cast<double>(count)) {
            const uint32_t h = f32::hash2(seed, static_cast<uint32_t>(out.size()));
            const float root = std::sqrt(f32::hashUnit(f32::hash2(h, 0))), share = f32::hashUnit(f32::hash2(h, 1));
            out.push_back({i, {1 - root, root * (1 - share), root * share}});
        }
    }
    return out;
}

std::vector<FittedRow> fitVertices(const Mesh& mesh, std::span<const SurfacePoint> points,
                                   std::span<const FittedRow> found) {
    Equations e{mesh, points, placesOf(mesh), {}};
    const uint32_t places = e.place.back();
    FittedRows out(mesh.vertices.size(), FittedRow{});
    if (points.empty()) return out;
    for (uint32_t i = 0; i + 2 < mesh.indices.size(); i += 3)
        for (uint32_t k = 0; k < 3; ++k) {
            const uint32_t a = e.place[mesh.indices[i + k]], b = e.place[mesh.indices[i + (k + 1) % 3]];
            if (a != b) e.edges.push_back({std::min(a, b), std::max(a, b)});
        }
    std::sort(e.edges.begin(), e.edges.end());
    e.edges.erase(std::unique(e.edges.begin(), e.edges.end()), e.edges.end());
    FittedRows right(places, FittedRow{});
    for (size_t i = 0; i < points.size(); ++i)
        for (int k = 0; k < 3; ++k)
            addTimes(right[e.placeOf(points[i], k)], points[i].counts * points[i].weights[k], found[i]);
    const FittedRows x = solve(e, right);
    for (size_t i = 0; i < out.size(); ++i) out[i] = x[e.place[i]];
    return out;
}

}  // namespace sward
