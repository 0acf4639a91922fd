#include "playtest/trunks.h"

#include <algorithm>
#include <cmath>

#include "world/ground.h"

namespace sward {
namespace {

constexpr double kTouch = 1e-9;   // metres: so near, circles touch
constexpr double kLevel = 1e-12;  // of a way: what of it goes into a trunk by rounding alone
constexpr int kMostTurns = 4;     // of one way, from trunk to trunk

double crossed(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }

// The first trunk that a circle meets which goes from a place by `way`, and at which share of it.
struct Meeting {
    const Trunk* trunk = nullptr;
    double share = 1;
};
Meeting firstMet(const std::vector<Trunk>& trunks, glm::dvec2 from, glm::dvec2 way, double radius) {
    Meeting first;
    const double square = glm::dot(way, way);
    for (const Trunk& t : trunks) {
        const glm::dvec2 off = from - t.at;
        const double reach = t.radius + radius, nears = glm::dot(off, way);
        if (nears >= -kLevel * glm::length(off) * std::sqrt(square)) continue;
        const double beyond = glm::dot(off, off) - reach * reach, root = nears * nears - square * beyond;
        if (beyond > 0 && root <= 0) continue;
        const double share = beyond <= 0 ? 0.0 : beyond / (-nears + std::sqrt(root));
        if (share >= 1 || (first.trunk && share >= first.share)) continue;
        first = {&t, share};
    }
    return first;
}

bool isFree(const std::vector<Trunk>& trunks, glm::dvec2 at, double radius) {
    return std::none_of(trunks.begin(), trunks.end(),
                        [&](const Trunk& t) { return t.radius + radius - glm::length(at - t.at) > kTouch; });
}

glm::dvec2 slid(const std::vector<Trunk>& trunks, glm::dvec2 from, glm::dvec2 to, double radius) {
    glm::dvec2 at = from, way = to - from, rest = way, before{0};
    for (int turns = 0; turns < kMostTurns; ++turns) {
        const Meeting met = firstMet(trunks, at, way, radius);
        if (!met.trunk) return turns == 0 ? to : at + way;
        at += way * met.share;
        const glm::dvec2 off = at - met.trunk->at;
        const double distance = glm::length(off);
        if (distance == 0) return at;
        const glm::dvec2 normal = off / distance;
        // Of what was wanted, not of what the last trunk left of it: else it would climb out of a flat corner, and
        // shake.
        rest *= 1 - met.share;
        way = rest - normal * std::min(glm::dot(rest, normal), 0.0);
        if (glm::dot(way, before) < -kLevel * glm::length(way)) return at;  // into the one that it came along
        before = normal;
    }
    return at;
}

// Where a circle touches a trunk and another one, or an edge: the corners of what is free.
void addCorners(std::vector<glm::dvec2>& out, const Trunk& a, const Trunk& b, double radius) {
    const glm::dvec2 gap = b.at - a.at;
    const double d = glm::length(gap), ra = a.radius + radius, rb = b.radius + radius;
    const double along = d > 0 ? (d * d + ra * ra - rb * rb) / (2 * d) : 0, aside = ra * ra - along * along;
    if (d == 0 || aside < 0) return;
    const glm::dvec2 n = gap / d, side = glm::dvec2(-n.y, n.x) * std::sqrt(aside);
    out.push_back(a.at + n * along + side);
    out.push_back(a.at + n * along - side);
}
void addCorners(std::vector<glm::dvec2>& out, const Trunk& t, double radius, glm::dvec2 least, glm::dvec2 most) {
    const double reach = t.radius + radius;
    for (const int axis : {0, 1})
        for (const double line : {least[axis], most[axis]}) {
            const double off = line - t.at[axis], aside = reach * reach - off * off;
            for (const double sign : {-1.0, 1.0}) {
                glm::dvec2 c(line);
                c[1 - axis] = t.at[1 - axis] + sign * std::sqrt(std::max(aside, 0.0));
                if (aside >= 0) out.push_back(c);
            }
        }
}

// The nearest free place is straight out of a trunk, or a corner.
std::vector<glm::dvec2> waysOut(const std::vector<Trunk>& trunks, glm::dvec2 at, double radius, glm::dvec2 least,
                                glm::dvec2 most) {
    std::vector<glm::dvec2> out;
    for (size_t i = 0; i < trunks.size(); ++i) {
        const Trunk& t = trunks[i];
        const double distance = glm::length(at - t.at);
        const glm::dvec2 normal = distance > 0 ? (at - t.at) / distance : glm::dvec2(1, 0);
        out.push_back(t.at + normal * (t.radius + radius));
        addCorners(out, t, radius, least, most);
        for (size_t k = i + 1; k < trunks.size(); ++k) addCorners(out, t, trunks[k], radius);
    }
    return out;
}

}  // namespace

PlayForest playForest(const Forest& forest, const Ground& ground) {
    PlayForest f{forestPlaces(forest, ground), 0};
    for (const TreeSpecies& s : forest.species)
        if (stands(s)) f.thickest = std::max(f.thickest, trunkRadius(s) * std::max(s.size.x, s.size.y));
    for (const auto& [x, i] : f.places.byHand) {
        const PlacedTree& tree = forest.placed[i];
        const TreeSpecies& s = forest.species[static_cast<size_t>(std::max(tree.species, 0))];
        f.thickest = std::max(f.thickest, trunkRadius(s) * static_cast<double>(tree.size));
    }
    return f;
}

std::vector<PlayForest> playForests(const Project& p) {
    std::vector<PlayForest> out;
    const Ground ground = findGround(p);
    for (const auto& [name, forest] : forestsOf(p)) out.push_back(playForest(*forest, ground));
    return out;
}

std::vector<Trunk> trunksNear(const PlayWorld& world, glm::dvec2 at, double radius, size_t* looked) {
    std::vector<Trunk> out;
    std::vector<StandingTree> trees;
    for (const PlayForest& f : world.forests) {
        const size_t n = treesNear(f.places, {&world.terrain, world.origin}, at, radius + f.thickest, trees);
        if (looked) *looked += n;
        for (const StandingTree& tree : trees) {
            const Trunk t{across(tree.at),
                          trunkRadius(f.places.rule.species[tree.species]) * static_cast<double>(tree.size)};
            if (glm::length(t.at - at) <= t.radius + radius) out.push_back(t);
        }
    }
    return out;
}

double depthInTrunks(const PlayWorld& world, glm::dvec2 at, double radius) {
    double depth = 0;
    for (const Trunk& t : trunksNear(world, at, radius))
        depth = std::max(depth, t.radius + radius - glm::length(at - t.at));
    return depth;
}

glm::dvec2 pastTrunks(const PlayWorld& world, glm::dvec2 from, glm::dvec2 to, double radius) {
    const std::vector<Trunk> trunks = trunksNear(world, from, radius + glm::length(to - from) + kTouch);
    const glm::dvec2 past = trunks.empty() ? to : slid(trunks, from, to, radius);
    if (past == to) return to;
    const glm::dvec2 inside = insideEdges(world, past, radius);
    return inside == past || isFree(trunks, inside, radius) ? inside : from;
}

glm::dvec2 outOfTrunks(const PlayWorld& world, glm::dvec2 at, double radius) {
    const std::vector<Trunk> around = trunksNear(world, at, radius);
    if (isFree(around, at, radius)) return at;
    double reach = radius;
    for (const Trunk& t : around) reach = std::max(reach, t.radius + radius);
    const glm::dvec2 least = insideEdges(world, glm::dvec2(-1e30), radius),
                     most = insideEdges(world, glm::dvec2(1e30), radius);
    for (const double room : {1.0, 2.0, 4.0, 8.0}) {
        const std::vector<Trunk> trunks = trunksNear(world, at, radius + room * reach);
        glm::dvec2 best = at;
        double nearest = room * reach + kTouch;
        for (const glm::dvec2& c : waysOut(trunks, at, radius, least, most)) {
            const double distance = glm::length(c - at);
            if (distance >= nearest || insideEdges(world, c, radius) != c || !isFree(trunks, c, radius)) continue;
            best = c;
            nearest = distance;
        }
        if (best != at) return best;
    }
    return at;
}

glm::dvec2 wayAroundTrunks(const PlayWorld& world, glm::dvec2 from, glm::dvec2 way, double radius) {
    const std::vector<Trunk> trunks = trunksNear(world, from, radius + glm::length(way));
    const Meeting met = firstMet(trunks, from, way, radius);
    if (!met.trunk) return way;
    const glm::dvec2 to = met.trunk->at - from;
    const double distance = glm::length(to);
    if (distance == 0) return way;
    const double sine = std::min((met.trunk->radius + radius) / distance, 1.0), cosine = std::sqrt(1 - sine * sine);
    const double side = crossed(to, way) > 0 ? sine : -sine;
    return glm::dvec2(to.x * cosine - to.y * side, to.x * side + to.y * cosine) / distance;
}

}  // namespace sward
