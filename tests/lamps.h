// Scenes that lamps alone light, and the ray-traced truth of the same view.
#pragma once
#include <array>
#include <vector>

#include "objects.h"
#include "reference/reference.h"

namespace sward::test {

// Gives the project a lamp that casts shadows; light: its other settings.
inline Light& putLamp(Project& p, const std::string& name, const glm::dvec3& at, Light light = {}) {
    light.type = LightType::Point;
    put<Transform>(p, name, {at});
    return put(p, name, light);
}

// cubeScene at night: a lamp 5 m high, south (+z) of the cube, of which it throws the shadow from z = 9 to z = 6.33.
inline Project cubeAtNight(const std::filesystem::path& dir) {
    Project p = cubeScene(dir);
    for (const char* name : {"sun", "sky"}) removeEntity(p, name);
    putLamp(p, "lamp", {10, 5, 13}, {.intensity = 8, .attenuation = 0.1f});
    return p;
}

// Down on the middle of ground of 20 x 20 m, and a square picture of that.
inline const ViewCamera kOver{{10, 16, 10.01}, {10, 0, 10}, 60, 0};
inline ViewSettings square() {
    ViewSettings s;
    s.width = 160, s.height = 160;
    s.measure = true;
    return s;
}
// Draws of a pass in the last frame.
inline uint64_t drawsOf(const Renderer& r, const std::string& name) {
    for (const PassStats& pass : r.stats().passes)
        if (pass.name == name) return pass.draws;
    return 0;
}

// Mean green of three by three pixels where a point of the world is seen.
inline float greenAt(const std::vector<float>& pixels, const ViewCamera& c, const ViewSettings& s,
                     const glm::dvec3& point) {
    const glm::vec4 clip = viewProjection(c, s.width, s.height) * glm::vec4(glm::vec3(point - c.eye), 1);
    const int x = static_cast<int>((clip.x / clip.w * 0.5f + 0.5f) * static_cast<float>(s.width)),
              y = static_cast<int>((0.5f - clip.y / clip.w * 0.5f) * static_cast<float>(s.height));
    EXPECT_TRUE(clip.w > 0 && x > 0 && y > 0 && x + 1 < s.width && y + 1 < s.height) << "not in the picture";
    float sum = 0;
    for (int i = 0; i < 9; ++i) sum += pixels[static_cast<size_t>((y - 1 + i / 3) * s.width + x - 1 + i % 3) * 3 + 1];
    return sum / 9;
}

// The picture, linear.
inline std::vector<float> drawnLight(Renderer& r, Project& p, const ViewCamera& c, const ViewSettings& s) {
    EXPECT_TRUE(r.draw(p, c, s));
    return r.readLinear();
}
inline std::vector<float> tracedLight(const Project& p, const ViewCamera& c, const ViewSettings& s, int samples) {
    JobControl control;
    const auto scene = ReferenceScene::make(p, tables(), s.time, control);
    EXPECT_TRUE(scene) << scene.error().text();
    ReferenceSettings settings;
    settings.width = s.width, settings.height = s.height, settings.samples = samples;
    settings.lighting = ReferenceLighting::Direct;
    return scene->trace(c, settings, control)->color;
}

// A picture, the truth, and the picture without shadows.
struct ThreePictures {
    std::vector<float> drawn, truth, open;
};
// casts: whether what casts the shadows does.
inline ThreePictures threePictures(Renderer& r, Project& p, const ViewCamera& c, const ViewSettings& s, bool& casts) {
    ThreePictures of;
    of.drawn = drawnLight(r, p, c, s);
    of.truth = tracedLight(p, c, s, 16);
    casts = false;
    of.open = drawnLight(r, p, c, s);
    casts = true;
    return of;
}
// By how much a picture changes at most, in levels of 255, where what casts shadows does not.
inline int mostShaded(Renderer& r, Project& p, const ViewCamera& c, bool& casts) {
    EXPECT_TRUE(r.draw(p, c, square()));
    const std::vector<uint8_t> shaded = r.readImage();
    casts = false;
    EXPECT_TRUE(r.draw(p, c, square()));
    const std::vector<uint8_t> open = r.readImage();
    casts = true;
    int most = 0;
    for (size_t i = 0; i < open.size(); ++i) most = std::max(most, std::abs(open[i] - shaded[i]));
    return most;
}

// A point of a surface, and four beside it.
struct Spot {
    glm::dvec3 at;
    std::array<glm::dvec3, 4> beside;
};
// Points of the ground (`height` at x and z), and those so many metres away on all four sides.
template <class F>
std::vector<Spot> groundSpots(const std::vector<glm::dvec2>& points, double beside, F height) {
    const auto ground = [&](double x, double z) { return glm::dvec3(x, height(x, z), z); };
    std::vector<Spot> spots;
    for (const glm::dvec2& p : points)
        spots.push_back({ground(p.x, p.y),
                         {ground(p.x + beside, p.y), ground(p.x - beside, p.y), ground(p.x, p.y + beside),
                          ground(p.x, p.y - beside)}});
    return spots;
}

// Whether the truth has all of the light at a point (1), none of it (-1), or is at an edge or without
// light worth a shadow (0). faint: light that is too little.
inline int truthAt(const ThreePictures& of, const ViewCamera& c, const ViewSettings& s, const glm::dvec3& at,
                   float faint) {
    const float truth = greenAt(of.truth, c, s, at), open = greenAt(of.open, c, s, at);
    return open < faint ? 0 : truth < 0.02f * open ? -1 : truth > 0.95f * open ? 1 : 0;
}

struct ShadowsSeen {
    int dark = 0, lit = 0;  // points
    float darkest = 0;      // the most light where it is dark, as a share of the light without shadows
    float off = 0;          // the most that lit points are off the truth, as a share
    float offOpen = 0;      // what is drawn there, as a share of the light without shadows
    glm::dvec3 darkestAt{0}, offAt{0};
};
// Of spots that are dark or lit in the truth, and so are those beside.
inline ShadowsSeen compareShadows(const ThreePictures& of, const ViewCamera& c, const ViewSettings& s,
                                  const std::vector<Spot>& spots) {
    float faint = 0;
    for (const Spot& spot : spots) faint = std::max(faint, 0.002f * greenAt(of.open, c, s, spot.at));
    ShadowsSeen seen;
    for (const auto& [at, beside] : spots) {
        const int truth = truthAt(of, c, s, at, faint);
        bool even = truth != 0;
        for (const glm::dvec3& by : beside) even = even && truthAt(of, c, s, by, faint) == truth;
        if (!even) continue;
        const float drawn = greenAt(of.drawn, c, s, at);
        const float share = drawn / greenAt(of.open, c, s, at), off = std::abs(drawn / greenAt(of.truth, c, s, at) - 1);
        ++(truth < 0 ? seen.dark : seen.lit);
        if (truth < 0 && share > seen.darkest) seen.darkest = share, seen.darkestAt = at;
        if (truth > 0 && off > seen.off) seen.off = off, seen.offAt = at, seen.offOpen = share;
    }
    return seen;
}
// Limits: 5 % of the light where the truth has none, 10 % off it where it has all; and so many points of each.
inline void expectAsInTruth(const ShadowsSeen& seen, int dark, int lit) {
    EXPECT_GT(seen.dark, dark);
    EXPECT_GT(seen.lit, lit);
    const auto text = [](const glm::dvec3& at) { return fmt::format("{} {} {}", at.x, at.y, at.z); };
    EXPECT_LT(seen.darkest, 0.05f) << text(seen.darkestAt);
    EXPECT_LT(seen.off, 0.1f) << text(seen.offAt) << ", where " << seen.offOpen
                              << " of the light without shadows is drawn";
    std::printf("%d dark points, at most %.4f of the light; %d lit ones, at most %.4f off\n", seen.dark,
                static_cast<double>(seen.darkest), seen.lit, static_cast<double>(seen.off));
}

}  // namespace sward::test
