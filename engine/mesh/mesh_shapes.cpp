#include "mesh/mesh_shapes.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <array>
#include <map>

#include "core/numerics.h"

namespace sward {
namespace {

// What is built, around the origin; moved to its place at the end.
struct Piece {
    std::vector<MeshVertex> vertices;
    std::vector<uint32_t> indices;
    uint32_t add(const glm::vec3& p, const glm::vec3& n, const glm::vec2& uv = glm::vec2(0)) {
        vertices.push_back({p, n, uv});
        return static_cast<uint32_t>(vertices.size()) - 1;
    }
    void quad(uint32_t a, uint32_t b, uint32_t c, uint32_t d) { indices.insert(indices.end(), {a, b, c, a, c, d}); }
};

// Six faces each have a square of the texture coordinates, three in a row, with a border that belongs to nobody.
// face: twice the axis it is across, and 1 for the positive side; at: in [0, 1] within its square.
glm::vec2 inChart(int face, const glm::vec2& at) {
    return (glm::vec2(static_cast<float>(face % 3), static_cast<float>(face / 3)) + 0.02f + 0.96f * at) / 3.0f;
}

void box(Piece& out, const Solid& s) {
    const glm::vec3 half(s.size.x / 2, s.size.y / 2, s.size.z / 2);
    const float most = std::max({s.size.x, s.size.y, s.size.z});
    for (int axis = 0; axis < 3; ++axis)
        for (const float side : {-1.0f, 1.0f}) {
            glm::vec3 n(0), u(0), v(0);
            n[axis] = side;
            u[(axis + 1) % 3] = side;
            v[(axis + 2) % 3] = 1;
            const int face = 2 * axis + (side > 0);
            const glm::vec2 share(s.size[(axis + 2) % 3] / most, s.size[(axis + 1) % 3] / most);
            const auto corner = [&](float a, float b) {
                const glm::vec2 uv = s.unwrap ? inChart(face, 0.5f + 0.5f * glm::vec2(b, a) * share) : glm::vec2(0);
                return out.add((n + u * a + v * b) * half + glm::vec3(0, half.y, 0), n, uv);
            };
            const uint32_t a = corner(-1, -1), b = corner(1, -1), c = corner(1, 1), d = corner(-1, 1);
            out.quad(a, b, c, d);
        }
}

// A disc at height y, seen from the side that n points to.
void disc(Piece& out, float radius, float y, int sides, const glm::vec3& n) {
    const uint32_t middle = out.add({0, y, 0}, n);
    for (int i = 0; i <= sides; ++i) {
        const float a = kFullTurn * static_cast<float>(i) / static_cast<float>(sides);
        const uint32_t at = out.add({radius * std::cos(a), y, radius * std::sin(a)}, n);
        if (i > 0)
            n.y > 0 ? out.indices.insert(out.indices.end(), {middle, at, at - 1})
                    : out.indices.insert(out.indices.end(), {middle, at - 1, at});
    }
}

void cylinder(Piece& out, const Solid& s) {
    const float bottom = s.size.x, height = s.size.y, top = s.size.z;
    const bool faceted = s.sides <= 8;  // so few are meant to be seen as edges
    for (int i = 0; i < s.sides; ++i) {
        const auto angle = [&](float k) { return kFullTurn * k / static_cast<float>(s.sides); };
        const auto normal = [&](float k) {
            const float a = angle(faceted ? static_cast<float>(i) + 0.5f : k);
            return glm::normalize(glm::vec3(height * std::cos(a), bottom - top, height * std::sin(a)));
        };
        const auto point = [&](float k, float r, float y) {
            return out.add({r * std::cos(angle(k)), y, r * std::sin(angle(k))}, normal(k));
        };
        const float k = static_cast<float>(i);
        const uint32_t a = point(k, bottom, 0), b = point(k + 1, bottom, 0), c = point(k + 1, top, height),
                       d = point(k, top, height);
        out.quad(a, d, c, b);
    }
    if (bottom > 0) disc(out, bottom, 0, s.sides, {0, -1, 0});
    if (top > 0) disc(out, top, height, s.sides, {0, 1, 0});
}

// Smooth noise over space, in [-1, 1].
float noise(const glm::vec3& p, uint32_t seed) {
    const glm::vec3 base = glm::floor(p), f = p - base, w = f * f * (3.0f - 2.0f * f);
    float sum = 0;
    for (int i = 0; i < 8; ++i) {
        const glm::vec3 corner(static_cast<float>(i & 1), static_cast<float>(i >> 1 & 1), static_cast<float>(i >> 2));
        const glm::ivec3 at(base + corner);
        const glm::vec3 share = glm::mix(1.0f - w, w, corner);
        const uint32_t h = f32::hash3(static_cast<uint32_t>(at.x), static_cast<uint32_t>(at.y),
                                      f32::hash2(static_cast<uint32_t>(at.z), seed));
        sum += share.x * share.y * share.z * (2 * f32::hashUnit(h) - 1);
    }
    return sum;
}

// Normals from the faces around each vertex.
void smoothNormals(Piece& out) {
    for (MeshVertex& v : out.vertices) v.normal = glm::vec3(0);
    for (size_t i = 0; i + 2 < out.indices.size(); i += 3) {
        MeshVertex &a = out.vertices[out.indices[i]], &b = out.vertices[out.indices[i + 1]],
                   &c = out.vertices[out.indices[i + 2]];
        const glm::vec3 n = glm::cross(b.position - a.position, c.position - a.position);
        a.normal += n, b.normal += n, c.normal += n;
    }
    for (MeshVertex& v : out.vertices)
        v.normal = glm::length(v.normal) > 0 ? glm::normalize(v.normal) : glm::vec3(0, 1, 0);
}

// Gives each of the ball's six faces vertices and a square of its own. cuts: squares along half a face's side, each of
// which is two steps of i and j wide.
void unwrapBall(Piece& ball, int cuts) {
    Piece out;
    const size_t perFace = ball.indices.size() / 6;
    for (size_t first = 0; first < ball.indices.size(); first += perFace) {
        const int face = static_cast<int>(first / perFace);
        std::map<uint32_t, uint32_t> known;
        for (size_t k = 0; k < perFace; ++k) {
            const size_t square = k / 6, corner = k % 6;
            const float i = static_cast<float>(square / static_cast<size_t>(cuts)) +
                            (corner == 1 || corner == 2 || corner == 4),
                        j = static_cast<float>(square % static_cast<size_t>(cuts)) +
                            (corner == 2 || corner == 4 || corner == 5);
            const MeshVertex& v = ball.vertices[ball.indices[first + k]];
            const auto [it, fresh] =
                known.try_emplace(ball.indices[first + k], static_cast<uint32_t>(out.vertices.size()));
            if (fresh) out.add(v.position, v.normal, inChart(face, glm::vec2(j, i) / static_cast<float>(cuts)));
            out.indices.push_back(it->second);
        }
    }
    ball = std::move(out);
}

// Six faces of a cube, each cut into squares, blown up to a ball: vertices on the edges are shared.
void ball(Piece& out, const Solid& s) {
    constexpr int kCuts = 12;
    std::map<std::array<int, 3>, uint32_t> known;
    const auto point = [&](const glm::ivec3& p) {
        const auto [it, fresh] = known.try_emplace({p.x, p.y, p.z}, static_cast<uint32_t>(out.vertices.size()));
        if (!fresh) return it->second;
        const glm::vec3 way = glm::normalize(glm::tan(glm::vec3(p) * (0.7853981f / kCuts)));
        float r = 1;
        for (int octave = 0; octave < 3 && s.rough > 0; ++octave)
            r += s.rough * noise(way * static_cast<float>(2 << octave) + 7.3f, s.seed + static_cast<uint32_t>(octave)) /
                 static_cast<float>(1 << octave);
        return out.add(way * s.size * r, way);
    };
    for (int axis = 0; axis < 3; ++axis)
        for (const int side : {-1, 1})
            for (int i = -kCuts; i < kCuts; i += 2)
                for (int j = -kCuts; j < kCuts; j += 2) {
                    const auto corner = [&](int a, int b) {
                        glm::ivec3 p(0);
                        p[axis] = side * kCuts, p[(axis + 1) % 3] = side * a, p[(axis + 2) % 3] = b;
                        return point(p);
                    };
                    out.quad(corner(i, j), corner(i + 2, j), corner(i + 2, j + 2), corner(i, j + 2));
                }
    smoothNormals(out);
    if (s.unwrap) unwrapBall(out, kCuts);
}

glm::vec3 anyDirection(uint32_t h) {
    const float y = 2 * f32::hashUnit(f32::hash2(h, 1)) - 1, a = kFullTurn * f32::hashUnit(f32::hash2(h, 2));
    const float r = std::sqrt(std::max(1 - y * y, 0.0f));
    return {r * std::cos(a), y, r * std::sin(a)};
}

// Leaf number i: two triangles, its normal mostly that of the ball, so that the crown is lit as a whole.
void leaf(Piece& out, const Solid& s, uint32_t i) {
    const uint32_t h = f32::hash3(i, s.seed, 77u);
    const glm::vec3 way = anyDirection(h), along = anyDirection(h ^ 0x55u);
    const glm::vec3 middle = way * s.size * (0.45f + 0.55f * std::sqrt(f32::hashUnit(f32::hash2(h, 3))));
    const glm::vec3 outward = glm::normalize(way / glm::max(s.size, glm::vec3(1e-3f)));
    const glm::vec3 face = glm::normalize(anyDirection(h ^ 0x3u) * 0.8f + outward);
    glm::vec3 length = along - face * glm::dot(along, face);
    length = glm::length(length) > 1e-3f ? glm::normalize(length)
                                         : glm::normalize(glm::cross(face, glm::vec3(0.3f, 0.5f, 0.8f)));
    const glm::vec3 across = glm::cross(face, length) * (0.32f * s.leaf), half = length * (0.5f * s.leaf);
    const glm::vec3 n = glm::normalize(outward + face * 0.35f);
    const uint32_t a = out.add(middle - half, n), b = out.add(middle + across, n), c = out.add(middle + half, n),
                   d = out.add(middle - across, n);
    out.quad(a, d, c, b);
}

struct Built {
    std::vector<std::pair<glm::vec3, Piece>> byColor;
    Piece& of(const glm::vec3& color) {
        for (auto& [c, piece] : byColor)
            if (c == color) return piece;
        return byColor.emplace_back(color, Piece{}).second;
    }
};

void place(Piece& to, const Piece& made, const Solid& s) {
    const glm::vec3 r = glm::radians(s.turnDeg);
    glm::mat4 m = glm::translate(glm::mat4(1), s.at);
    m = glm::rotate(m, r.y, glm::vec3(0, 1, 0));
    m = glm::rotate(m, r.z, glm::vec3(0, 0, 1));
    m = glm::rotate(m, r.x, glm::vec3(1, 0, 0));
    const uint32_t base = static_cast<uint32_t>(to.vertices.size());
    for (const MeshVertex& v : made.vertices)
        to.add(glm::vec3(m * glm::vec4(v.position, 1)), glm::vec3(m * glm::vec4(v.normal, 0)), v.uv);
    for (const uint32_t i : made.indices) to.indices.push_back(base + i);
}

void build(Built& out, const Solid& s) {
    if (s.kind == SolidKind::Leaves) {
        constexpr float kTints[] = {0.75f, 1.0f, 1.3f};
        for (uint32_t tint = 0; tint < 3; ++tint) {
            Piece piece;
            for (uint32_t i = tint; i < static_cast<uint32_t>(s.count); i += 3) leaf(piece, s, i);
            place(out.of(glm::min(s.color * kTints[tint], glm::vec3(1))), piece, s);
        }
        return;
    }
    Piece piece;
    if (s.kind == SolidKind::Box) box(piece, s);
    if (s.kind == SolidKind::Cylinder) cylinder(piece, s);
    if (s.kind == SolidKind::Ball) ball(piece, s);
    place(out.of(s.color), piece, s);
}

}  // namespace

Mesh makeMesh(std::span<const Solid> solids) {
    Built built;
    for (const Solid& s : solids) build(built, s);
    Mesh mesh;
    for (const auto& [color, piece] : built.byColor) {
        if (piece.indices.empty()) continue;
        MeshPart part;
        part.first = static_cast<uint32_t>(mesh.indices.size());
        part.count = static_cast<uint32_t>(piece.indices.size());
        part.color = color;
        const uint32_t base = static_cast<uint32_t>(mesh.vertices.size());
        for (const uint32_t i : piece.indices) mesh.indices.push_back(base + i);
        mesh.vertices.insert(mesh.vertices.end(), piece.vertices.begin(), piece.vertices.end());
        mesh.parts.push_back(part);
    }
    updateBounds(mesh);
    return mesh;
}

}  // namespace sward
