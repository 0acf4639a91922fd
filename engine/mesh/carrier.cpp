#include "mesh/carrier.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>
#include <unordered_map>
#include <unordered_set>

#include "core/hash.h"
#include "core/numerics.h"

namespace sward {
namespace {

// A triangle's texture coordinates as functions over its plane.
struct Mapping {
    glm::dvec3 alongU{0}, alongV{0};  // gradients
    double area = 0, uvArea = 0;      // uvArea: signed
};
Mapping mappingOf(const MeshVertex& a, const MeshVertex& b, const MeshVertex& c) {
    const glm::dvec3 p = glm::dvec3(b.position) - glm::dvec3(a.position),
                     q = glm::dvec3(c.position) - glm::dvec3(a.position);
    const glm::dvec2 s = glm::dvec2(b.uv) - glm::dvec2(a.uv), t = glm::dvec2(c.uv) - glm::dvec2(a.uv);
    const double pp = glm::dot(p, p), pq = glm::dot(p, q), qq = glm::dot(q, q), det = pp * qq - pq * pq;
    Mapping m;
    m.area = 0.5 * std::sqrt(std::max(det, 0.0));
    m.uvArea = 0.5 * (s.x * t.y - s.y * t.x);
    // As thin as rounding: an area of either that says nothing.
    const double longest = std::max(pp, qq), widest = std::max(glm::dot(s, s), glm::dot(t, t));
    if (!(m.area > 1e-7 * longest)) m.area = 0;
    if (!(std::abs(m.uvArea) > 1e-7 * widest)) m.uvArea = 0;
    if (m.area == 0 || m.uvArea == 0) return m;
    const auto gradient = [&](double ofP, double ofQ) {
        return ((ofP * qq - ofQ * pq) * p + (ofQ * pp - ofP * pq) * q) / det;
    };
    m.alongU = gradient(s.x, t.x), m.alongV = gradient(s.y, t.y);
    return m;
}

struct PlaceHash {
    size_t operator()(const std::pair<glm::vec3, glm::vec3>& p) const { return hashBytes(&p, sizeof(p)); }
};
// Numbers of vertices by place and normal: where both agree the surface goes on, whatever its texture coordinates.
std::vector<uint32_t> weldedPlaces(const std::vector<CarrierVertex>& vertices) {
    std::unordered_map<std::pair<glm::vec3, glm::vec3>, uint32_t, PlaceHash> known;
    std::vector<uint32_t> out;
    for (const CarrierVertex& v : vertices)
        out.push_back(
            known.try_emplace({v.position + 0.0f, v.normal + 0.0f}, static_cast<uint32_t>(known.size())).first->second);
    return out;
}

// Sums over a vertex's triangles.
struct Gathered {
    glm::dvec3 alongU{0}, alongV{0};
    double area = 0;
};

// One vertex for each of the mesh's and each handedness in which triangles use it.
struct Splitting {
    MeshCarrier& out;
    const Mesh& mesh;
    std::vector<uint32_t> place[2];
    std::vector<Gathered> gathered;

    Splitting(MeshCarrier& carrier, const Mesh& from) : out(carrier), mesh(from) {
        for (auto& p : place) p.assign(from.vertices.size(), ~0u);
    }
    uint32_t at(uint32_t vertex, bool mirrored) {
        uint32_t& number = place[mirrored][vertex];
        if (number == ~0u) {
            number = static_cast<uint32_t>(out.vertices.size());
            const MeshVertex& v = mesh.vertices[vertex];
            out.vertices.push_back({v.position, v.normal, v.uv, {}, {}, glm::vec3(0)});
            out.vertices.back().of = vertex;
            gathered.emplace_back();
        }
        return number;
    }
    void add(const uint32_t* corners) {
        const Mapping m = mappingOf(mesh.vertices[corners[0]], mesh.vertices[corners[1]], mesh.vertices[corners[2]]);
        out.unmapped += m.uvArea == 0 && m.area > 0;
        if (m.uvArea == 0 || m.area == 0) return;
        const bool mirrored = m.uvArea > 0;  // u, v and the outward normal are as x, z and up are: left-handed
        out.mirrored += mirrored;
        out.area += m.area, out.uvArea += std::abs(m.uvArea);
        for (int k = 0; k < 3; ++k) {
            const uint32_t number = at(corners[k], mirrored);
            out.indices.push_back(number);
            Gathered& g = gathered[number];
            g.alongU += m.alongU * m.area, g.alongV += m.alongV * m.area, g.area += m.area;
        }
    }
};

// The part of v in the plane across n.
glm::dvec3 inPlane(const glm::dvec3& v, const glm::dvec3& n) { return v - n * glm::dot(v, n); }

void setDirections(CarrierVertex& v, const Gathered& g, double uvPerLength) {
    const glm::dvec3 n(v.normal), u = inPlane(g.alongU / g.area, n), w = inPlane(g.alongV / g.area, n);
    const double least = 1e-3 * uvPerLength;
    const bool directed = glm::length(u) > least && glm::length(w) > least &&
                          glm::length(glm::cross(u, w)) > 1e-3 * glm::length(u) * glm::length(w);
    v.alongU = glm::vec3(u), v.alongV = glm::vec3(w);
    if (directed) return;
    const f32::TangentFrame f = f32::tangentFrame(v.normal);
    v.alongU = f.tangent * static_cast<float>(uvPerLength), v.alongV = -f.bitangent * static_cast<float>(uvPerLength);
}

// Least squares over the edges that leave a vertex: dn . e = e K e, each as much as its length says nothing of.
struct Bending {
    glm::dmat3 sums{0};
    glm::dvec3 right{0};
    void add(const CarrierVertex& from, const CarrierVertex& to) {
        const CarrierFrame f = carrierFrame(from.normal, from.alongU, from.alongV);
        const glm::vec3 e = to.position - from.position;
        const glm::dvec2 along(glm::dot(e, f.tangent), glm::dot(e, f.bitangent));
        const double l2 = glm::dot(along, along);
        if (!(l2 > 0)) return;
        const glm::dvec3 row = glm::dvec3(along.x * along.x, 2 * along.x * along.y, along.y * along.y) / l2;
        const double k = static_cast<double>(glm::dot(to.normal - from.normal, e)) / l2;
        sums += glm::outerProduct(row, row);
        right += row * k;
    }
    glm::vec3 solved() const {
        const double ridge = 1e-6 * (sums[0][0] + sums[1][1] + sums[2][2]);
        if (!(ridge > 0)) return glm::vec3(0);
        return glm::vec3(glm::inverse(sums + glm::dmat3(ridge)) * right);
    }
};
void setBends(MeshCarrier& c) {
    std::vector<Bending> bends(c.vertices.size());
    for (size_t i = 0; i < c.indices.size(); i += 3)
        for (size_t k = 0; k < 3; ++k) {
            const uint32_t a = c.indices[i + k], b = c.indices[i + (k + 1) % 3];
            bends[a].add(c.vertices[a], c.vertices[b]);
            bends[b].add(c.vertices[b], c.vertices[a]);
        }
    for (size_t i = 0; i < bends.size(); ++i) c.vertices[i].bend = bends[i].solved();
}

// A bend as a tensor in the mesh's axes, and back.
glm::dmat3 tensorOf(const CarrierVertex& v) {
    const CarrierFrame f = carrierFrame(v.normal, v.alongU, v.alongV);
    const glm::dvec3 t(f.tangent), b(f.bitangent);
    const glm::dvec3 k(v.bend);
    return k.x * glm::outerProduct(t, t) + k.y * (glm::outerProduct(t, b) + glm::outerProduct(b, t)) +
           k.z * glm::outerProduct(b, b);
}
glm::vec3 bendOf(const CarrierVertex& v, const glm::dmat3& tensor) {
    const CarrierFrame f = carrierFrame(v.normal, v.alongU, v.alongV);
    const glm::dvec3 t(f.tangent), b(f.bitangent);
    return glm::vec3(glm::dot(t, tensor * t), glm::dot(t, tensor * b), glm::dot(b, tensor * b));
}

// Rays go on by what a vertex bends: means over its surroundings say more of where they go than what is roughest.
constexpr int kSmoothings = 4;  // each reaches an edge farther
void smoothBends(MeshCarrier& c, const std::vector<uint32_t>& place) {
    const size_t places = place.empty() ? 0 : *std::max_element(place.begin(), place.end()) + size_t{1};
    std::vector<glm::dmat3> tensors(places, glm::dmat3(0));
    std::vector<double> count(places, 0);
    for (size_t i = 0; i < c.vertices.size(); ++i) tensors[place[i]] += tensorOf(c.vertices[i]), count[place[i]] += 1;
    for (size_t i = 0; i < places; ++i) tensors[i] /= count[i];
    for (int round = 0; round < kSmoothings; ++round) {
        std::vector<glm::dmat3> sums = tensors;
        std::fill(count.begin(), count.end(), 1.0);
        for (size_t i = 0; i < c.indices.size(); ++i) {
            const uint32_t a = place[c.indices[i]], b = place[c.indices[i % 3 == 2 ? i - 2 : i + 1]];
            sums[a] += tensors[b], sums[b] += tensors[a], count[a] += 1, count[b] += 1;
        }
        for (size_t i = 0; i < places; ++i) tensors[i] = sums[i] / count[i];
    }
    for (size_t i = 0; i < c.vertices.size(); ++i) c.vertices[i].bend = bendOf(c.vertices[i], tensors[place[i]]);
}

// Parts of the texture coordinates hang together by the vertices that triangles share.
uint32_t rootOf(std::vector<uint32_t>& parent, uint32_t v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
}
void setCharts(MeshCarrier& c) {
    std::vector<uint32_t> parent(c.vertices.size());
    std::iota(parent.begin(), parent.end(), 0u);
    for (size_t i = 0; i < c.indices.size(); i += 3)
        for (size_t k = 1; k < 3; ++k) parent[rootOf(parent, c.indices[i + k])] = rootOf(parent, c.indices[i]);
    std::vector<glm::vec4> charts(c.vertices.size(), glm::vec4(1e30f, 1e30f, -1e30f, -1e30f));
    for (uint32_t v = 0; v < c.vertices.size(); ++v) {
        glm::vec4& chart = charts[rootOf(parent, v)];
        const glm::vec2 uv = c.vertices[v].uv;
        chart = {glm::min(glm::vec2(chart.x, chart.y), uv), glm::max(glm::vec2(chart.z, chart.w), uv)};
    }
    for (uint32_t v = 0; v < c.vertices.size(); ++v) c.vertices[v].chart = charts[rootOf(parent, v)];
}

// Parts of the surface hang together by the places that triangles share.
void setParts(MeshCarrier& c, const std::vector<uint32_t>& place) {
    std::vector<uint32_t> parent(c.vertices.size());
    std::iota(parent.begin(), parent.end(), 0u);
    for (size_t i = 0; i < c.indices.size(); i += 3)
        for (size_t k = 1; k < 3; ++k)
            parent[rootOf(parent, place[c.indices[i + k]])] = rootOf(parent, place[c.indices[i]]);
    std::unordered_map<uint32_t, size_t> numbers;
    for (uint32_t v = 0; v < c.vertices.size(); ++v)
        c.vertices[v].part =
            static_cast<float>(1 + numbers.try_emplace(rootOf(parent, place[v]), numbers.size()).first->second);
    c.parts = numbers.size();
}

// Walls along directed edges that no triangle has the other way round. Parts that have some are marked.
void addSkirts(MeshCarrier& c, const std::vector<uint32_t>& place) {
    const auto key = [](uint32_t a, uint32_t b) { return uint64_t(a) << 32 | b; };
    std::vector<uint64_t> edges;
    for (size_t i = 0; i < c.surface; ++i)
        edges.push_back(key(place[c.indices[i]], place[c.indices[i % 3 == 2 ? i - 2 : i + 1]]));
    std::sort(edges.begin(), edges.end());
    std::unordered_set<float> edged;
    for (size_t i = 0; i < c.surface; ++i) {
        const uint32_t a = c.indices[i], b = c.indices[i % 3 == 2 ? i - 2 : i + 1];
        if (std::binary_search(edges.begin(), edges.end(), key(place[b], place[a]))) continue;
        edged.insert(c.vertices[a].part);
        const uint32_t first = static_cast<uint32_t>(c.vertices.size());
        for (const uint32_t v : {a, b}) {
            CarrierVertex low = c.vertices[v];
            low.lift = 0;
            c.vertices.push_back(low);
        }
        c.indices.insert(c.indices.end(), {first, first + 1, b, first, b, a});
    }
    for (CarrierVertex& v : c.vertices)
        if (edged.contains(v.part)) v.part = -v.part;
}

// Boxes around triangles that follow each other, which mostly lie beside each other.
void setBoxes(MeshCarrier& c) {
    for (size_t i = 0; i < c.surface; i += kBoxIndices) {
        glm::vec3 low(INFINITY), high(-INFINITY);
        for (size_t k = i; k < std::min(i + kBoxIndices, c.surface); ++k) {
            const glm::vec3& p = c.vertices[c.indices[k]].position;
            low = glm::min(low, p), high = glm::max(high, p);
        }
        c.boxes.emplace_back(low, high);
    }
}

// Weights of a triangle's corners at its point nearest to p: over the plane, or else on the nearest edge.
glm::vec3 nearestOnEdge(const glm::vec3& a, const glm::vec3& b, const glm::vec3& p) {
    const glm::vec3 along = b - a;
    const float t = glm::clamp(glm::dot(p - a, along) / std::max(glm::dot(along, along), 1e-30f), 0.0f, 1.0f);
    return {1 - t, t, 0};
}
glm::vec3 nearestOnTriangle(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& p) {
    const glm::vec3 n = glm::cross(b - a, c - a);
    const float area = std::max(glm::dot(n, n), 1e-30f);
    const glm::vec3 inside(glm::dot(glm::cross(c - b, p - b), n) / area, glm::dot(glm::cross(a - c, p - c), n) / area,
                           glm::dot(glm::cross(b - a, p - a), n) / area);
    if (inside.x >= 0 && inside.y >= 0 && inside.z >= 0) return inside;
    const glm::vec3 ab = nearestOnEdge(a, b, p), bc = nearestOnEdge(b, c, p), ca = nearestOnEdge(c, a, p);
    glm::vec3 best(0);
    float least = INFINITY;
    for (const glm::vec3& w : {ab, glm::vec3(0, bc.x, bc.y), glm::vec3(ca.y, 0, ca.x)})
        if (const glm::vec3 d = a * w.x + b * w.y + c * w.z - p; glm::dot(d, d) < least)
            least = glm::dot(d, d), best = w;
    return best;
}

CarrierVertex mixed(const CarrierVertex& a, const CarrierVertex& b, const CarrierVertex& c, const glm::vec3& w) {
    CarrierVertex out = a;
    const auto mix = [&](auto CarrierVertex::*m) { out.*m = a.*m * w.x + b.*m * w.y + c.*m * w.z; };
    mix(&CarrierVertex::position), mix(&CarrierVertex::normal), mix(&CarrierVertex::uv);
    mix(&CarrierVertex::alongU), mix(&CarrierVertex::alongV), mix(&CarrierVertex::bend);
    out.normal = glm::dot(out.normal, out.normal) > 1e-12f ? glm::normalize(out.normal) : a.normal;
    return out;
}

}  // namespace

CarrierVertex nearestOn(const MeshCarrier& carrier, const glm::vec3& p) {
    CarrierVertex best;
    float least = INFINITY;
    for (size_t box = 0; box < carrier.boxes.size(); ++box) {
        const auto& [low, high] = carrier.boxes[box];
        const glm::vec3 off = glm::max(glm::max(low - p, p - high), glm::vec3(0));
        if (!(glm::dot(off, off) < least)) continue;
        for (size_t i = box * kBoxIndices; i < std::min((box + 1) * kBoxIndices, carrier.surface); i += 3) {
            const CarrierVertex &a = carrier.vertices[carrier.indices[i]],
                                &b = carrier.vertices[carrier.indices[i + 1]],
                                &c = carrier.vertices[carrier.indices[i + 2]];
            const glm::vec3 w = nearestOnTriangle(a.position, b.position, c.position, p),
                            d = a.position * w.x + b.position * w.y + c.position * w.z - p;
            if (glm::dot(d, d) < least) least = glm::dot(d, d), best = mixed(a, b, c, w);
        }
    }
    return best;
}

CarrierFrame carrierFrame(const glm::vec3& normal, const glm::vec3& alongU, const glm::vec3& alongV) {
    const glm::vec3 t = glm::normalize(alongU - normal * glm::dot(alongU, normal));
    const glm::vec3 b = glm::cross(t, normal);
    return {t, glm::dot(b, alongV) < 0 ? -b : b};
}

double lengthOfUv(const MeshCarrier& c) { return c.uvArea > 0 ? std::sqrt(c.area / c.uvArea) : 0; }

MeshCarrier carrierOf(const Mesh& mesh) {
    MeshCarrier out;
    Splitting split(out, mesh);
    for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3) split.add(&mesh.indices[i]);
    const double uvPerLength = out.area > 0 ? std::sqrt(out.uvArea / out.area) : 1;
    for (size_t i = 0; i < out.vertices.size(); ++i) setDirections(out.vertices[i], split.gathered[i], uvPerLength);
    out.surface = out.indices.size();
    setBends(out);
    setCharts(out);
    const std::vector<uint32_t> place = weldedPlaces(out.vertices);
    smoothBends(out, place);
    setParts(out, place);
    addSkirts(out, place);
    setBoxes(out);
    return out;
}

}  // namespace sward
