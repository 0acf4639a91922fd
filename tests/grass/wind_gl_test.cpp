// How much of the wind each species takes, in pictures of every technique: by its stiffness.
#include "world/wind.h"

#include <cmath>

#include "fields.h"
#include "grass/comparison.h"
#include "reference/reference.h"
#include "scenes.h"
#include "support.h"
#include "techniques.h"
#include "world/view_camera.h"

namespace sward::test {
namespace {

FlatField windyGrass(Project& p) { return flatField(p, "grass"); }
std::vector<uint8_t> windyPicture(Renderer& r, Project& p, const ViewCamera& camera, const ViewSettings& settings) {
    const Status drawn = r.draw(p, camera, settings);
    EXPECT_TRUE(drawn) << drawn.error().text();
    return r.readImage();
}

// --- every technique ---------------------------------------------------------------------------------------

struct Way {
    const char* name;
    Technique technique;
    Tessellation tessellation = Tessellation::Auto;
    Population population = Population::Patch;
};
const Way kWays[] = {{"hybrid", Technique::Hybrid},
                     {"geometry", Technique::Geometry},
                     {"slices", Technique::Slices},
                     {"flat", Technique::Flat},
                     {"stages", Technique::Tessellated, Tessellation::Stages},
                     {"strips", Technique::Tessellated, Tessellation::Strips},
                     {"geometry of unique blades", Technique::Geometry, Tessellation::Auto, Population::Unique},
                     {"strips of unique blades", Technique::Tessellated, Tessellation::Strips, Population::Unique}};

// Two species, of which the second is low; all tiers are in view, shadows on the ground too.
Project windy(const Way& way) {
    Project p = lawn();
    FlatField f = windyGrass(p);
    f.technique = nameOf(way.technique), f.tessellation = way.tessellation, f.population = way.population;
    f.minGeom = 2, f.maxGeom = 4, f.minBTF = 6, f.maxBTF = 9, f.maxDistance = 15;
    f.sliceWidth = f.sliceHeight = f.farSize = 32;
    f.species.push_back(f.species[0]);
    f.species[1].name = "low", f.species[1].height = 0.07f;
    Wind wind;
    wind.turbulence = 1, wind.gustSize = 3;
    put(p, "wind", wind);
    return p;
}
std::vector<uint8_t> windyPicture(Renderer& r, const Way& way, float strength, float first, float second) {
    Project p = windy(way);
    p.registry.get<Wind>(findEntity(p, "wind"))->strength = strength;
    windyGrass(p).species[0].stiffness = first, windyGrass(p).species[1].stiffness = second;
    ViewSettings s = small();
    s.time = 3;
    return windyPicture(r, p, eyeHeight(), s);
}

TEST(Stiffness, OfTwoHalvesTheWindInEveryTechniqueForItsOwnSpecies) {
    NoGlErrors errors;
    for (const Way& way : kWays) {
        Renderer r(gpu(), tables());
        const auto picture = [&](float strength, float first, float second) {
            return windyPicture(r, way, strength, first, second);
        };
        const auto half = picture(0.3f, 1, 1), whole = picture(0.6f, 1, 1), first = picture(0.6f, 2, 1),
                   second = picture(0.6f, 1, 2);
        EXPECT_TRUE(half == picture(0.6f, 2, 2)) << way.name;
        EXPECT_TRUE(whole == picture(0.3f, 0.5f, 0.5f)) << way.name;
        EXPECT_TRUE(half != whole && first != half && first != whole && second != half && second != whole &&
                    first != second)
            << way.name;
        EXPECT_TRUE(picture(0, 1, 1) == picture(0, 0.05f, 100)) << way.name << ", in a calm";
    }
}

// --- by how far they are blown aside -----------------------------------------------------------------------

constexpr int kWidth = 192, kHeight = 72;

// Upright blades in a strip that runs away from the eye, in a wind that blows evenly to the right.
Project strip(Technique technique, float stiffness) {
    Project p = lawn();
    FlatField f = windyGrass(p);
    f.technique = nameOf(technique);
    f.minGeom = 100, f.maxGeom = 200, f.minBTF = 300, f.maxBTF = 400;
    f.maxDistance = 400, f.thinning = 0, f.lowerFrom = 1, f.beyond = Beyond::Nothing;
    f.sliceWidth = 128, f.sliceHeight = 64, f.farSize = 32, f.farHeight = 0, f.shadowMask = 0, f.groundShadows = false;
    Species& s = f.species[0];
    s.bladesPerM2 = 1500, s.height = 1, s.heightVariation = 0, s.bend = s.leanDeg = s.leanVariationDeg = 0,
    s.clumpStrength = 0, s.width = 0.03f;
    s.stiffness = stiffness;
    Map density({40, 40, 1, PixelType::U8});
    for (int y = 10; y < 30; ++y)
        for (int x = 19; x < 21; ++x) density.set(x, y, 0, 1);
    s.density = field(density, "maps/d.png");
    Wind wind;
    wind.strength = 0.4f, wind.azimuthDeg = 90, wind.turbulence = 0;
    wind.gusts = field(filled({4, 4, 1, PixelType::U8}, 1), "maps/g.png");
    put(p, "wind", wind);
    return p;
}
ViewCamera along() { return {{10, 0.5, 40}, {10, 0.5, 10}, 3, 0}; }

// How far the grass leans to the right, metres a metre of blade: the slope of the line through the means of its rows.
// Rows are not equally covered, but each is the strip's width. weight: how much of pixel i is grass.
template <class Weight>
double leanOf(Weight weight) {
    double n = 0, x = 0, y = 0, xy = 0, yy = 0;
    for (int row = 0; row < kHeight; ++row) {
        double all = 0, sum = 0;
        for (int column = 0; column < kWidth; ++column) {
            const double w = weight(static_cast<size_t>(row * kWidth + column));
            all += w, sum += w * column;
        }
        if (all < 20) continue;
        const double mean = sum / all, up = kHeight - row;
        n += 1, x += mean, y += up, xy += mean * up, yy += up * up;
    }
    EXPECT_GT(n, 20);
    const double slope = (xy - x * y / n) / (yy - y * y / n);
    return slope / std::sqrt(1 + slope * slope);
}
double drawnLean(Renderer& r, Technique technique, float stiffness) {
    Project p = strip(technique, stiffness);
    ViewSettings s;
    s.width = kWidth, s.height = kHeight, s.mode = ViewMode::Tiers;
    const auto with = windyPicture(r, p, along(), s);
    p.registry.remove<GrassField>(findEntity(p, "grass"));
    const auto without = windyPicture(r, p, along(), s);
    return leanOf([&](size_t i) {
        return std::abs(with[3 * i] - without[3 * i]) + std::abs(with[3 * i + 1] - without[3 * i + 1]) +
                           std::abs(with[3 * i + 2] - without[3 * i + 2]) >
                       24
                   ? 1.0
                   : 0.0;
    });
}
double tracedLean(float stiffness) {
    const Project p = strip(Technique::Geometry, stiffness);
    JobControl control;
    auto scene = ReferenceScene::make(p, tables(), 0, control);
    ReferenceSettings s;
    s.width = kWidth, s.height = kHeight, s.samples = 2, s.lighting = ReferenceLighting::Direct;
    const auto truth = scene->trace(along(), s, control);
    EXPECT_TRUE(truth);
    return leanOf([&](size_t i) { return static_cast<double>(truth->grass[i]); });
}

TEST(Stiffness, DividesTheLeanOfBladesAsOfSlicesAndInTheTruth) {
    NoGlErrors errors;
    Renderer r(gpu(), tables());
    const auto check = [&](const char* what, const auto& leanAt) {
        const double soft = leanAt(0.5f), one = leanAt(1.0f), four = leanAt(4.0f);
        std::printf("  %s lean %.3f m/m at stiffness 0.5, %.3f at 1, %.3f at 4\n", what, soft, one, four);
        EXPECT_NEAR(soft, 0.8, 0.06) << what;
        EXPECT_NEAR(one, 0.4, 0.03) << what;
        EXPECT_NEAR(four, 0.1, 0.02) << what;
    };
    check("blades", [&](float s) { return drawnLean(r, Technique::Geometry, s); });
    check("tessellated blades", [&](float s) { return drawnLean(r, Technique::Tessellated, s); });
    check("slices", [&](float s) { return drawnLean(r, Technique::Slices, s); });
    check("blades of the truth", tracedLean);
}

// --- what faces keep ---------------------------------------------------------------------------------------

// How far faces turn between two winds, of what the eye sees of them: the median over pixels that show grass in both
// pictures, degrees. Blades that move aside show others behind them, but most pixels keep theirs.
double turnedDeg(Renderer& r, Technique technique, float fromDeg, float toDeg) {
    const auto drawn = [&](float azimuthDeg, ViewMode mode) {
        Project p = strip(technique, 1);
        windyGrass(p).species[0].bladesPerM2 = 200, windyGrass(p).species[0].height = 0.5f;
        Wind& wind = *p.registry.get<Wind>(findEntity(p, "wind"));
        wind.strength = 0.03f, wind.azimuthDeg = azimuthDeg;
        ViewSettings s;
        s.width = kWidth, s.height = kHeight, s.msaa = 1, s.mode = mode;
        return windyPicture(r, p, {{10, 1, 16.5}, {10, 0.2, 14}, 40, 0}, s);
    };
    const auto before = drawn(fromDeg, ViewMode::Normals), after = drawn(toDeg, ViewMode::Normals);
    const auto bladeBefore = bladePixels(drawn(fromDeg, ViewMode::Tiers)),
               bladeAfter = bladePixels(drawn(toDeg, ViewMode::Tiers));
    const auto normal = [](const std::vector<uint8_t>& rgb, size_t i) {
        return glm::normalize(glm::vec3(rgb[3 * i], rgb[3 * i + 1], rgb[3 * i + 2]) / 127.5f - 1.0f);
    };
    std::vector<double> turned;
    for (size_t i = 0; i < bladeBefore.size(); ++i) {
        if (!bladeBefore[i] || !bladeAfter[i]) continue;
        const float same = std::abs(glm::dot(normal(before, i), normal(after, i)));
        turned.push_back(static_cast<double>(glm::degrees(std::acos(std::min(same, 1.0f)))));
    }
    EXPECT_GT(turned.size(), 500u);
    std::sort(turned.begin(), turned.end());
    return turned.empty() ? 0 : turned[turned.size() / 2];
}

// A wind that leans blades by 3 cm a metre once turned all of them to itself.
TEST(Faces, AreNotSpunByAWeakWindThatTurns) {
    NoGlErrors errors;
    Renderer r(gpu(), tables());
    for (const Technique technique : {Technique::Geometry, Technique::Tessellated}) {
        const double turned = turnedDeg(r, technique, 0, 90);
        std::printf("  %s: faces turn by %.1f degrees\n", nameOf(technique), turned);
        EXPECT_LT(turned, 20) << nameOf(technique);
    }
}

// --- what presses ------------------------------------------------------------------------------------------

TEST(Stiffness, DoesNotHoldUpWhatAFootPresses) {
    NoGlErrors errors;
    for (const Technique technique : {Technique::Geometry, Technique::Tessellated}) {
        Renderer r(gpu(), tables());
        const auto picture = [&](float stiffness, bool pressed) {
            Project p = strip(technique, stiffness);
            Map force({4, 4, 4, PixelType::U8});
            for (int i = 0; pressed && i < 16; ++i) force.set(i % 4, i / 4, 2, 1), force.set(i % 4, i / 4, 3, 1);
            windyGrass(p).forces = field(force, "maps/f.png");
            windyGrass(p).drawing.bakeLight = BakeLight::Local;  // pictures are one to the byte, or not
            ViewSettings s;
            s.width = kWidth, s.height = kHeight;
            return windyPicture(r, p, along(), s);
        };
        const auto flat = picture(1, true);
        EXPECT_TRUE(flat == picture(100, true)) << nameOf(technique);
        EXPECT_TRUE(flat != picture(100, false)) << nameOf(technique);
        EXPECT_TRUE(picture(1, false) != picture(100, false)) << nameOf(technique);
    }
}

}  // namespace
}  // namespace sward::test
