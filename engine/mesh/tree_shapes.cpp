#include "mesh/tree_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "core/numerics.h"

namespace sward {
namespace {

constexpr float kGoldenTurn = 2.3999632f;  // radians from branch to branch: no two lie over each other
constexpr int kTints = 3;                  // of leaves

// Numbers in a row from one seed.
struct Dice {
    uint32_t seed, at = 0;
    float unit() { return f32::hashUnit(f32::hash2(seed, at++)); }
    float in(float low, float high) { return low + (high - low) * unit(); }
    glm::vec3 direction() {
        const float y = in(-1, 1), turn = in(0, kFullTurn), r = std::sqrt(std::max(1 - y * y, 0.0f));
        return {r * std::cos(turn), y, r * std::sin(turn)};
    }
};

struct Grower {
    const TreeShape& shape;
    Dice dice;
    Mesh mesh;
    std::array<std::vector<uint32_t>, 1 + kTints> indices{};  // bark, then leaves by their tint

    uint32_t add(const glm::vec3& at, const glm::vec3& normal) {
        // Whatever chance adds stays within the crown.
        glm::vec3 p = at;
        const float reach = shape.crown * shape.height * 0.5f, r = std::hypot(p.x, p.z);
        if (r > reach) p.x *= reach / r, p.z *= reach / r;
        p.y = std::clamp(p.y, 0.0f, shape.height);
        mesh.vertices.push_back({p, normal, glm::vec2(0)});
        return static_cast<uint32_t>(mesh.vertices.size()) - 1;
    }
    // A tube from a to b that becomes thinner; `sides` faces, open at both ends.
    void limb(const glm::vec3& a, const glm::vec3& b, float thick, float thin, int sides) {
        const glm::vec3 way = glm::normalize(b - a);
        const glm::vec3 u =
            glm::normalize(glm::cross(way, std::abs(way.y) > 0.9f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0)));
        const glm::vec3 v = glm::cross(way, u);
        for (int i = 0; i <= sides; ++i) {
            const float turn = kFullTurn * static_cast<float>(i) / static_cast<float>(sides);
            const glm::vec3 out = u * std::cos(turn) + v * std::sin(turn);
            const uint32_t low = add(a + out * thick, out), high = add(b + out * thin, out);
            if (i > 0) indices[0].insert(indices[0].end(), {low - 2, low, high, low - 2, high, high - 2});
        }
    }
    // A leaf from `at` along `way`, folded along its middle; it faces `up` as far as it can.
    void leaf(const glm::vec3& at, const glm::vec3& way, const glm::vec3& up, float length, float width) {
        const glm::vec3 along = glm::normalize(way);
        glm::vec3 side = glm::cross(along, up);
        if (glm::dot(side, side) < 1e-8f) side = glm::cross(along, glm::vec3(0.31f, 0.2f, 0.93f));
        side = glm::normalize(side);
        const glm::vec3 n = glm::normalize(glm::cross(side, along));
        const glm::vec3 middle = at + along * (length * 0.45f);
        const uint32_t a = add(at, n), b = add(middle + side * (width * 0.5f), glm::normalize(n + side * 0.3f)),
                       c = add(at + along * length, n),
                       d = add(middle - side * (width * 0.5f), glm::normalize(n - side * 0.3f));
        const size_t tint = 1 + static_cast<size_t>(dice.unit() * kTints) % kTints;
        indices[tint].insert(indices[tint].end(), {a, b, c, a, c, d});
    }
    Mesh finish() {
        constexpr float kTintOf[kTints] = {0.78f, 1.0f, 1.25f};
        for (size_t i = 0; i < indices.size(); ++i) {
            if (indices[i].empty()) continue;
            const glm::vec3 color = i == 0 ? shape.barkColor : shape.leafColor * kTintOf[i - 1];
            mesh.parts.push_back({static_cast<uint32_t>(mesh.indices.size()), static_cast<uint32_t>(indices[i].size()),
                                  glm::min(color, glm::vec3(1)), -1, 0});
            mesh.indices.insert(mesh.indices.end(), indices[i].begin(), indices[i].end());
        }
        updateBounds(mesh);
        return std::move(mesh);
    }
};

void growConifer(Grower& g) {
    const float h = g.shape.height, reach = g.shape.crown * h * 0.5f, from = 0.08f * h;
    g.limb({0, 0, 0}, {0, 0.97f * h, 0}, 0.014f * h, 0.002f * h, 7);
    const int branches = std::clamp(g.shape.leaves / 20, 12, 160);
    // More branches low down, where they are long: their number follows the crown's outline.
    std::vector<float> weight(static_cast<size_t>(branches));
    float all = 0;
    struct Branch {
        glm::vec3 from, way;
        float length;
    };
    std::vector<Branch> made;
    for (int i = 0; i < branches; ++i) {
        const float t = 1 - std::sqrt(1 - (static_cast<float>(i) + 0.5f) / static_cast<float>(branches) * 0.995f);
        const float outline = (1 - t) * 0.94f + 0.04f;
        const float length = reach * outline * g.dice.in(0.72f, 1.0f);
        const float turn = static_cast<float>(i) * kGoldenTurn + g.dice.in(-0.3f, 0.3f);
        const float rise = glm::mix(-0.32f, 0.55f, t * t) + g.dice.in(-0.08f, 0.08f);
        made.push_back({{0, from + t * (0.94f * h - from), 0},
                        glm::normalize(glm::vec3(std::cos(turn), rise, std::sin(turn))),
                        length});
        weight[static_cast<size_t>(i)] = length;
        all += length;
    }
    float owed = 0;
    for (size_t i = 0; i < made.size(); ++i) {
        const Branch& b = made[i];
        g.limb(b.from, b.from + b.way * b.length, 0.0032f * h * (0.4f + b.length / reach), 0.0006f * h, 3);
        owed += static_cast<float>(g.shape.leaves) * weight[i] / all;
        const int count = static_cast<int>(owed);
        owed -= static_cast<float>(count);
        const glm::vec3 aside = glm::normalize(glm::cross(b.way, glm::vec3(0, 1, 0)));
        for (int k = 0; k < count; ++k) {
            const float s = std::sqrt((static_cast<float>(k) + g.dice.unit()) / static_cast<float>(count));
            const float side = k % 2 ? 1.0f : -1.0f, spray = 0.085f * h * (0.55f + 0.45f * (1 - s));
            // Twigs to both sides of the branch, a little down, rolled about themselves.
            const glm::vec3 way =
                b.way * 0.75f + aside * (side * g.dice.in(0.25f, 0.95f)) + glm::vec3(0, g.dice.in(-0.5f, 0.12f), 0);
            g.leaf(b.from + b.way * (b.length * (0.12f + 0.86f * s)), way, g.dice.direction() + glm::vec3(0, 0.8f, 0),
                   spray * g.dice.in(0.7f, 1.1f), spray * 0.34f);
        }
    }
}

// Clumps of leaves within the crown, each on a limb that leaves the trunk below it.
void growClumps(Grower& g, float lowest, float trunkTop, float hang, float leafSize) {
    const float h = g.shape.height, reach = g.shape.crown * h * 0.5f;
    const float middle = (1 + lowest) * 0.5f * h, half = (1 - lowest) * 0.5f * h;
    const int clumps = std::clamp(g.shape.leaves / 36, 8, 90);
    const float radius = std::cbrt(reach * reach * half / static_cast<float>(clumps)) * 0.95f;
    float owed = 0;
    for (int i = 0; i < clumps; ++i) {
        // Spread evenly over the directions, most near the outline.
        const float y = 1 - 2 * (static_cast<float>(i) + 0.5f) / static_cast<float>(clumps),
                    turn = static_cast<float>(i) * kGoldenTurn;
        const float ring = std::sqrt(std::max(1 - y * y, 0.0f)), out = std::cbrt(g.dice.in(0.25f, 1));
        glm::vec3 c(ring * std::cos(turn) * (reach - radius * 0.7f) * out, middle + y * (half - radius * 0.8f) * out,
                    ring * std::sin(turn) * (reach - radius * 0.7f) * out);
        c += g.dice.direction() * (radius * 0.25f);
        const float root = std::min(std::max(c.y - std::hypot(c.x, c.z) * 0.9f, lowest * h * 0.75f), trunkTop * h);
        g.limb({0, root, 0}, c, 0.006f * h, 0.0012f * h, 3);
        owed += static_cast<float>(g.shape.leaves) / static_cast<float>(clumps);
        const int count = static_cast<int>(owed);
        owed -= static_cast<float>(count);
        for (int k = 0; k < count; ++k) {
            const glm::vec3 d = g.dice.direction();
            const float r = std::cbrt(g.dice.in(0.2f, 1)) * radius;
            const glm::vec3 at = c + glm::vec3(d.x, d.y * (0.75f + hang) - hang * g.dice.unit(), d.z) * r;
            const glm::vec3 way = g.dice.direction() + d * 0.4f - glm::vec3(0, 0.35f + hang, 0);
            g.leaf(at, way, g.dice.direction() + d * 0.5f, leafSize * g.dice.in(0.75f, 1.25f), leafSize * 0.62f);
        }
    }
}

void growBroadleaf(Grower& g) {
    const float h = g.shape.height;
    const glm::vec3 bend(g.dice.in(-0.02f, 0.02f) * h, 0.45f * h, g.dice.in(-0.02f, 0.02f) * h);
    g.limb({0, 0, 0}, bend, 0.026f * h, 0.018f * h, 8);
    g.limb(bend, {bend.x * 0.5f, 0.8f * h, bend.z * 0.5f}, 0.018f * h, 0.004f * h, 6);
    const float area = g.shape.crown * h * h * 0.55f;  // of the crown's outline from the side
    growClumps(g, 0.26f, 0.62f, 0, std::sqrt(area * 9.0f / static_cast<float>(g.shape.leaves)));
}

void growBirch(Grower& g) {
    const float h = g.shape.height;
    const glm::vec3 bend(g.dice.in(-0.025f, 0.025f) * h, 0.5f * h, g.dice.in(-0.025f, 0.025f) * h);
    g.limb({0, 0, 0}, bend, 0.012f * h, 0.008f * h, 7);
    g.limb(bend, {bend.x * 0.3f, 0.95f * h, bend.z * 0.3f}, 0.008f * h, 0.0015f * h, 5);
    const float area = g.shape.crown * h * h * 0.5f;
    growClumps(g, 0.22f, 0.85f, 0.5f, std::sqrt(area * 6.5f / static_cast<float>(g.shape.leaves)));
}

uint32_t rootOf(std::vector<uint32_t>& up, uint32_t v) {
    while (up[v] != v) v = up[v] = up[up[v]];
    return v;
}

}  // namespace

Mesh growTree(const TreeShape& shape) {
    Grower g{shape, {f32::hash2(shape.seed, 0x7ee5u)}, {}};
    if (shape.kind == TreeKind::Conifer) growConifer(g);
    if (shape.kind == TreeKind::Broadleaf) growBroadleaf(g);
    if (shape.kind == TreeKind::Birch) growBirch(g);
    return g.finish();
}

Mesh thinned(const Mesh& mesh, float keep, int most) {
    if (!(keep < 1)) return mesh;
    // Pieces that share no vertex: each vertex points to the least of its piece.
    std::vector<uint32_t> up(mesh.vertices.size());
    std::iota(up.begin(), up.end(), 0u);
    for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
        for (size_t k = 1; k < 3; ++k) {
            const uint32_t a = rootOf(up, mesh.indices[i]), b = rootOf(up, mesh.indices[i + k]);
            up[std::max(a, b)] = std::min(a, b);
        }
    struct Piece {
        int triangles = 0;
        glm::vec3 sum{0};  // of its triangles' corners
    };
    std::vector<Piece> pieces(mesh.vertices.size());
    for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        Piece& p = pieces[rootOf(up, mesh.indices[i])];
        ++p.triangles;
        for (size_t k = 0; k < 3; ++k) p.sum += mesh.vertices[mesh.indices[i + k]].position;
    }
    const float grown = 1 / std::sqrt(keep);
    Mesh out;
    out.files = mesh.files;
    out.images = mesh.images;
    std::vector<uint32_t> number(mesh.vertices.size(), ~0u);
    const auto vertex = [&](uint32_t v) {
        if (number[v] != ~0u) return number[v];
        const Piece& p = pieces[rootOf(up, v)];
        MeshVertex copy = mesh.vertices[v];
        if (p.triangles <= most) {
            const glm::vec3 centre = p.sum / static_cast<float>(3 * p.triangles);
            copy.position = glm::clamp(centre + (copy.position - centre) * grown, mesh.low, mesh.high);
        }
        out.vertices.push_back(copy);
        return number[v] = static_cast<uint32_t>(out.vertices.size()) - 1;
    };
    for (const MeshPart& part : mesh.parts) {
        MeshPart now = part;
        now.first = static_cast<uint32_t>(out.indices.size());
        for (uint32_t i = part.first; i + 2 < part.first + part.count; i += 3) {
            const uint32_t piece = rootOf(up, mesh.indices[i]);
            if (pieces[piece].triangles <= most && f32::hashUnit(f32::hash2(piece, 0x1eafu)) >= keep) continue;
            for (uint32_t k = 0; k < 3; ++k) out.indices.push_back(vertex(mesh.indices[i + k]));
        }
        now.count = static_cast<uint32_t>(out.indices.size()) - now.first;
        if (now.count > 0) out.parts.push_back(now);
    }
    updateBounds(out);
    return out;
}

}  // namespace sward
