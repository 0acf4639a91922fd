// Water against geometry, against the ray-traced truth, and against what it may not cost.
#include "core/numerics.h"
#include "fields.h"
#include "gl_calls.h"
#include "lamps.h"
#include "objects.h"
#include "reference/reference.h"
#include "scene/antialias.h"
#include "techniques.h"
#include "world/ground.h"
#include "world/view_camera.h"

namespace sward::test {
namespace {

constexpr int kWidth = 120, kHeight = 90;

// Level ground half a metre under still water; a white cube that stands out of it by 1.5 m. No wind.
Project lake(const TempDir& folder) {
    Project p;
    p.dir = folder.path;
    Terrain t;
    t.size = {30, 30};
    put(p, "ground", t);
    put<Water>(p, "lake", {.level = 0.5f, .reflection = 1});
    put<Light>(p, "sun", {.azimuthDeg = 180, .elevationDeg = 50});
    put<Sky>(p, "sky");
    putObject(p, "cube", {{.size = {2, 2, 2}, .color = {0.8f, 0.1f, 0.1f}}}, {15, 0, 12});
    return p;
}
ViewCamera ashore() { return {{15, 2.0, 20}, {15, 0.5, 12}, 50, 0}; }
ViewSettings settings() {
    ViewSettings s;
    s.width = kWidth, s.height = kHeight;
    return s;
}

std::vector<float> drawn(Project& p, const ViewCamera& c, double time = 0) {
    Renderer r(gpu(), tables());
    ViewSettings s = settings();
    s.time = time;
    const Status done = r.draw(p, c, s);
    EXPECT_TRUE(done) << (done ? "" : done.error().text());
    return r.readLinear();
}
Truth tracedWater(const Project& p, const ViewCamera& c, int samples) {
    JobControl control;
    auto scene = ReferenceScene::make(p, tables(), 0, control);
    EXPECT_TRUE(scene) << (scene ? "" : scene.error().text());
    ReferenceSettings s;
    s.width = kWidth, s.height = kHeight, s.samples = samples, s.lighting = ReferenceLighting::Direct;
    auto t = scene->trace(c, s, control);
    EXPECT_TRUE(t);
    return *t;
}

// How red a row is against how blue, over a few pixels about x: rays are thrown back by chance.
double redness(const std::vector<float>& image, int x, int y) {
    double red = 0, blue = 1e-6;
    for (int i = x - 4; i <= x + 4; ++i) {
        const float* v = &image[3 * (static_cast<size_t>(y) * kWidth + static_cast<size_t>(i))];
        red += static_cast<double>(v[0]), blue += static_cast<double>(v[2]);
    }
    return red / blue;
}
// The row, with fractions, in which the mirrored cube's top edge lies in a column: from red to sky, looking down the
// picture.
double mirroredEdge(const std::vector<float>& image, int x, int from) {
    const double red = redness(image, x, from), sky = redness(image, x, kHeight - 4), middle = (red + sky) / 2;
    for (int y = from; y + 1 < kHeight; ++y)
        if (redness(image, x, y) >= middle && redness(image, x, y + 1) < middle)
            return y + (redness(image, x, y) - middle) / (redness(image, x, y) - redness(image, x, y + 1));
    return -1;
}
double rowOf(const ViewCamera& c, const glm::dvec3& point) {
    const glm::vec4 clip = viewProjection(c, kWidth, kHeight) * glm::vec4(glm::vec3(point - c.eye), 1);
    return static_cast<double>((0.5f - 0.5f * clip.y / clip.w) * kHeight) - 0.5;
}

TEST(Water, StillWaterMirrorsAnObjectToThePixel) {
    NoGlErrors errors;
    const TempDir folder;
    Project p = lake(folder);
    const ViewCamera c = ashore();
    const std::vector<float> picture = drawn(p, c), truth = tracedWater(p, c, 256).color;
    // The front's upper edge stands at y = 2, its image at 2 * 0.5 - 2.
    const double edge = rowOf(c, {15, -1, 13});
    const int inside = static_cast<int>(edge) - 4;
    EXPECT_NEAR(mirroredEdge(picture, kWidth / 2, inside), edge, 1);
    EXPECT_NEAR(mirroredEdge(truth, kWidth / 2, inside), edge, 1);
    EXPECT_NEAR(mirroredEdge(picture, kWidth / 2 + 6, inside), mirroredEdge(truth, kWidth / 2 + 6, inside), 1);
}

// Frames that add up are drawn into two images, after water has been blended by two colours.
TEST(Water, OfFramesThatAddUpIsAsBrightAsOfOne) {
    TempDir folder;
    Project p = lake(folder);
    const std::vector<float> one = drawn(p, ashore());
    put<Antialias>(p, "antialias", {.antialias = Antialiasing::Temporal});
    const std::vector<float> many = drawn(p, ashore());
    double a = 0, b = 0;
    for (size_t i = 0; i < one.size(); ++i) a += double(one[i]), b += double(many[i]);
    EXPECT_NEAR(b / a, 1, 0.01);
}

TEST(Water, StillWaterIsTheTruthsInLight) {
    NoGlErrors errors;
    const TempDir folder;
    Project p = lake(folder);
    p.registry.get<Water>(findEntity(p, "lake"))->clarity = 0.4f;  // what bends under water is a difference of its own
    const ViewCamera c = ashore();
    const std::vector<float> picture = drawn(p, c), truth = tracedWater(p, c, 64).color;
    for (const int y : {kHeight - 6, kHeight - 20, kHeight * 2 / 3})
        for (int k = 0; k < 3; ++k) {
            double a = 0, b = 0;
            for (int x = 10; x < kWidth - 10; ++x) {
                const size_t i =
                    3 * (static_cast<size_t>(y) * kWidth + static_cast<size_t>(x)) + static_cast<size_t>(k);
                a += static_cast<double>(picture[i]), b += static_cast<double>(truth[i]);
            }
            EXPECT_NEAR(a / b, 1, 0.06) << "row " << y << " channel " << k;
        }
}

TEST(Water, RippledWaterIsAsBrightAsTheTruth) {
    NoGlErrors errors;
    const TempDir folder;
    Project p = lake(folder);
    p.registry.get<Water>(findEntity(p, "lake"))->clarity = 0.4f;
    put<Wind>(p, "wind");
    const ViewCamera c = ashore();
    const std::vector<float> picture = drawn(p, c), truth = tracedWater(p, c, 64).color;
    double a = 0, b = 0;
    for (size_t i = static_cast<size_t>(kHeight * 3 / 4) * kWidth * 3; i < picture.size(); ++i)
        a += static_cast<double>(picture[i]), b += static_cast<double>(truth[i]);
    EXPECT_NEAR(a / b, 1, 0.1);
}

// Ripples that are smaller than a pixel smear what is mirrored along the view, by the Gaussian of their slopes: how
// much sky the water shows before a red wall, row by row. Over one standard deviation each way, evenly, it is off by
// 0.067.
TEST(Water, SmearsWhatItMirrorsAsTheTruth) {
    NoGlErrors errors;
    const TempDir folder;
    Project p = lake(folder);
    p.registry.get<Water>(findEntity(p, "lake"))->clarity = 0.1f;
    put<Wind>(p, "wind", {.speed = 6});
    putObject(p, "wall", {{.size = {12, 2.5f, 0.5f}, .color = {0.8f, 0.1f, 0.1f}}}, {15, 0, 10});
    const ViewCamera c{{15, 1.3, 29}, {15, 0.4, 12}, 20, 0};
    const std::vector<float> picture = drawn(p, c), truth = tracedWater(p, c, 256).color;
    const int first = static_cast<int>(rowOf(c, {15, 0.5, 13})) + 2;
    const auto sky = [&](const std::vector<float>& image, int y) {
        double sum = 0;
        for (int x = kWidth / 2 - 8; x < kWidth / 2 + 8; ++x)
            sum += static_cast<double>(image[3 * (static_cast<size_t>(y) * kWidth + static_cast<size_t>(x)) + 2]) / 16;
        return sum;
    };
    double square = 0, sum = 0;
    for (int y = first; y < kHeight; ++y) {
        const double off = sky(picture, y) - sky(truth, y);
        square += off * off, sum += sky(truth, y);
    }
    EXPECT_LT(std::sqrt(square * (kHeight - first)) / sum, 0.05);
}

// The lake at night over black ground, with a lamp beside the cube.
Project lakeAtNight(const TempDir& folder) {
    Project p = lake(folder);
    for (const char* name : {"sun", "sky"}) removeEntity(p, name);
    p.registry.get<Terrain>(findEntity(p, "ground"))->groundColor = glm::vec3(0);
    p.registry.get<Water>(findEntity(p, "lake"))->clarity = 0.4f;
    putLamp(p, "lamp", {11, 2.5, 14}, {.intensity = 8, .attenuation = 0.1f});
    return p;
}
double allGreen(const std::vector<float>& image) {
    double sum = 0;
    for (size_t i = 1; i < image.size(); i += 3) sum += static_cast<double>(image[i]);
    return sum;
}

TEST(Water, ALampGlintsAsInTheTruth) {
    NoGlErrors errors;
    const TempDir folder;
    const ViewCamera across{{11, 2.2, 20}, {11, 0.5, 15}, 50, 0};
    for (const bool windy : {false, true}) {
        Project p = lakeAtNight(folder);
        if (windy) put<Wind>(p, "wind");
        const std::vector<float> picture = drawn(p, across), truth = tracedWater(p, across, 256).color;
        const float most = *std::max_element(picture.begin(), picture.end()),
                    mostTrue = *std::max_element(truth.begin(), truth.end());
        std::printf("%s: %.4f of the truth's light; the brightest pixel %.4f of the truth's\n",
                    windy ? "ripples" : "still", allGreen(picture) / allGreen(truth),
                    static_cast<double>(most / mostTrue));
        EXPECT_GT(mostTrue, 100) << "the glint";
        EXPECT_NEAR(most / mostTrue, 1, 0.1f);
        EXPECT_NEAR(allGreen(picture) / allGreen(truth), 1, 0.1);
    }
}

TEST(Water, ALampLightsItAndABoxShadesThatAsInTheTruth) {
    NoGlErrors errors;
    const TempDir folder;
    Project p = lakeAtNight(folder);
    const ViewCamera over{{15, 14, 12.01}, {15, 0, 12}, 50, 0};
    const std::vector<float> picture = drawn(p, over), truth = tracedWater(p, over, 64).color;
    // South of the cube, and north-east of it, where it hides the lamp.
    const auto at = [&](const std::vector<float>& image, const glm::dvec3& place) {
        ViewSettings s = settings();
        return greenAt(image, over, s, place);
    };
    for (const glm::dvec3& lit : {glm::dvec3(15, 0.5, 15), glm::dvec3(12, 0.5, 11), glm::dvec3(18, 0.5, 15)}) {
        EXPECT_GT(at(truth, lit), 0.003f) << lit.x;
        EXPECT_NEAR(at(picture, lit) / at(truth, lit), 1, 0.1f) << lit.x;
    }
    const glm::dvec3 dark(17, 0.5, 10.6);
    EXPECT_LT(at(truth, dark), 1e-4f);
    EXPECT_LT(at(picture, dark), 0.02f * at(picture, {18, 0.5, 15}));
}

std::vector<std::string> passesOf(Renderer& r, Project& p, const ViewCamera& c) {
    EXPECT_TRUE(r.draw(p, c, settings()));
    std::vector<std::string> names;
    for (const PassStats& s : r.stats().passes) names.push_back(s.name);
    return names;
}
bool holds(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

// Two ponds on level ground, with a red cube beyond each.
Project ponds(const TempDir& folder) {
    Project p = lake(folder);
    for (const char* name : {"lake", "cube"}) removeEntity(p, name);
    const struct {
        const char* name;
        double x;
        float level;
    } both[] = {{"left", 9, 0.2f}, {"right", 21, 1.0f}};
    for (const auto& pond : both) {
        put<Transform>(p, pond.name).position = {pond.x, 0, 14};
        *p.registry.add<Water>(findEntity(p, pond.name)) = {
            .level = pond.level, .radius = 4, .clarity = 0.2f, .reflection = 1};
        putObject(p, std::string(pond.name) + "-cube", {{.size = {3, 2, 1}, .color = {0.8f, 0.1f, 0.1f}}},
                  {pond.x, 0, 9});
    }
    return p;
}
ViewCamera overPonds() { return {{15, 4, 27}, {15, 0.5, 12}, 50, 0}; }

// Mean difference of blocks of 4 x 4 pixels, over the blocks' mean light, where the truth's ray meets a pond's place.
double pondError(const Project& land, const std::vector<float>& a, const std::vector<float>& b, const ViewCamera& c) {
    double off = 0, light = 0;
    int blocks = 0;
    for (int y = 0; y + 4 <= kHeight; y += 4)
        for (int x = 0; x + 4 <= kWidth; x += 4) {
            const auto at = pickGround(land, c, kWidth, kHeight, x + 2.0, y + 2.0);
            if (!at || std::min(std::hypot(at->x - 9, at->z - 14), std::hypot(at->x - 21, at->z - 14)) > 3) continue;
            double sum[2] = {};
            for (int i = 0; i < 16 * 3; ++i) {
                const size_t pixel = static_cast<size_t>(y + i / 12) * kWidth + static_cast<size_t>(x + i / 3 % 4);
                sum[0] += double(a[3 * pixel + static_cast<size_t>(i % 3)]);
                sum[1] += double(b[3 * pixel + static_cast<size_t>(i % 3)]);
            }
            off += std::abs(sum[0] - sum[1]), light += sum[1];
            ++blocks;
        }
    EXPECT_GT(blocks, 20);
    return off / light;
}

double rmsOff(const std::vector<float>& a, const std::vector<float>& b) {
    double sum = 0;
    for (size_t i = 0; i < a.size(); ++i) sum += double((a[i] - b[i]) * (a[i] - b[i]));
    return std::sqrt(sum / static_cast<double>(a.size()));
}

TEST(Water, EachPondMirrorsAtItsOwnLevelAsTheTruthDoes) {
    NoGlErrors errors;
    const TempDir folder;
    Project p = ponds(folder);
    const ViewCamera c = overPonds();
    const std::vector<float> truth = tracedWater(p, c, 256).color;
    const double ours = pondError(p, drawn(p, c), truth, c);
    p.registry.get<Water>(findEntity(p, "right"))->level = 0.2f;
    const double oneLevel = pondError(p, drawn(p, c), truth, c);
    std::printf("ponds against the truth: %.4f; both of one level: %.4f\n", ours, oneLevel);
    EXPECT_LT(ours, 0.06);
    EXPECT_GT(oneLevel, 2 * ours);
}

TEST(Water, APondEndsWhereItsPlaceDoes) {
    NoGlErrors errors;
    const TempDir folder;
    Project p = ponds(folder);
    const ViewCamera c = overPonds();
    const std::vector<float> wet = drawn(p, c);
    for (const char* name : {"left", "right"}) removeEntity(p, name);
    const std::vector<float> dry = drawn(p, c);
    int same = 0, other = 0;
    for (int x = 0; x < kWidth; ++x) {
        const size_t i = 3 * (static_cast<size_t>(rowOf(c, {15, 0, 14})) * kWidth + static_cast<size_t>(x));
        (std::equal(&wet[i], &wet[i] + 3, &dry[i]) ? same : other) += 1;
    }
    EXPECT_GT(other, kWidth / 3);
    EXPECT_GT(same, kWidth / 4) << "between and beside them";
    const size_t between = 3 * (static_cast<size_t>(rowOf(c, {15, 0, 14})) * kWidth + kWidth / 2);
    EXPECT_EQ(wet[between], dry[between]);
}

// A small red pond within a wide blue one: the higher one hides the other where both stand; of two as high, the first,
// which is the small one.
Project pondInPond(const TempDir& folder, float small, float wide, const std::string& without) {
    Project p = lake(folder);
    for (const char* name : {"lake", "cube"}) removeEntity(p, name);
    const struct {
        const char* name;
        float level, radius;
        glm::vec3 color;
    } both[] = {{"small", small, 4, {0.4f, 0.05f, 0.02f}}, {"wide", wide, 9, {0.02f, 0.05f, 0.4f}}};
    for (const auto& pond : both) {
        if (pond.name == without) continue;
        put<Transform>(p, pond.name).position = {15, 0, 14};
        *p.registry.add<Water>(findEntity(p, pond.name)) = {
            .level = pond.level, .radius = pond.radius, .clarity = 1, .color = pond.color, .reflection = 1};
    }
    return p;
}
TEST(Water, OfTwoOverEachOtherTheFirstMetIsSeenAlone) {
    NoGlErrors errors;
    const TempDir folder;
    const ViewCamera c{{15, 5, 27}, {15, 0.5, 14}, 50, 0};
    const struct { float small, wide; } all[] = {{0.5f, 0.5f}, {0.3f, 0.9f}, {0.9f, 0.3f}};
    for (const auto& level : all) {
        const auto seen = [&](const std::string& without) {
            Project p = pondInPond(folder, level.small, level.wide, without);
            return drawn(p, c);
        };
        Project p = pondInPond(folder, level.small, level.wide, "");
        const std::vector<float> picture = drawn(p, c), wide = seen("small"), small = seen("wide");
        int asWide = 0, asSmall = 0, asNone = 0;
        for (size_t i = 0; i < picture.size(); i += 3) {
            const auto equals = [&](const std::vector<float>& other) {
                return std::equal(&picture[i], &picture[i] + 3, &other[i]);
            };
            if (equals(wide))
                ++asWide;
            else if (equals(small))
                ++asSmall;
            else
                ++asNone;
        }
        EXPECT_EQ(asNone, 0) << level.small << " in " << level.wide;
        EXPECT_GT(asWide, 4000) << level.small << " in " << level.wide;
        EXPECT_EQ(asSmall > 500, level.small >= level.wide) << asSmall;
        const std::vector<float> truth = tracedWater(p, c, 64).color;
        const double ours = rmsOff(picture, truth), other = rmsOff(level.small < level.wide ? small : wide, truth);
        std::printf("%.1f in %.1f: off the truth by %.4f, without what hides by %.4f\n", double(level.small),
                    double(level.wide), ours, other);
        EXPECT_LT(ours, 0.7 * other);
    }
}

// The mirror's bytes follow what of the picture its water takes, and an eye that moves makes none of it anew.
TEST(Water, OnlyThatPartIsMirroredInWhichAPondIsSeen) {
    NoGlErrors errors;
    const TempDir folder;
    Project p = ponds(folder);
    removeEntity(p, "right");
    ViewCamera c{{15, 4, 29}, {15, 2, 12}, 70, 0};
    Water& pond = *p.registry.get<Water>(findEntity(p, "left"));
    int64_t bytes[2] = {};
    for (const bool everywhere : {false, true}) {
        pond.radius = everywhere ? 0.0f : 1.5f;
        Renderer r(gpu(), tables());
        passesOf(r, p, c);
        bytes[everywhere] = gpu().ledger.at("water/reflection");
    }
    EXPECT_LT(double(bytes[0]), 0.35 * double(bytes[1]));
    pond.radius = 1.5f;
    Renderer r(gpu(), tables());
    passesOf(r, p, c);
    passesOf(r, p, c);
    CountGlCalls count;
    for (int i = 0; i < 20; ++i) {
        c.eye.x += 0.02, c.target.x += 0.02;
        passesOf(r, p, c);
    }
    EXPECT_LE(glCalls.byName["glCreateTextures"], 3u) << "a step of the part's size, once";
}

// Frames that add up sample all of a mirror's pixel, which is larger than the picture's: edges in it are smooth.
TEST(Water, CoarseMirrorsAddUpToSmoothEdges) {
    NoGlErrors errors;
    const TempDir folder;
    Project p = ponds(folder);
    const ViewCamera c = overPonds();
    put<Antialias>(p, "antialias", {.antialias = Antialiasing::Temporal});
    const auto settled = [&](float reflection) {
        for (const char* name : {"left", "right"}) p.registry.get<Water>(findEntity(p, name))->reflection = reflection;
        Renderer r(gpu(), tables());
        EXPECT_TRUE(drawSettled(r, p, c, settings()));
        return r.readLinear();
    };
    const std::vector<float> fine = settled(1), coarse = settled(0.25f);
    p.registry.remove<Antialias>(findEntity(p, "antialias"));
    const std::vector<float> once = drawn(p, c);  // four samples a pixel, the mirror's as well
    const double added = rmsOff(coarse, fine), four = rmsOff(once, fine);
    std::printf("coarse mirror off the fine one: %.5f where frames add up, %.5f of four samples\n", added, four);
    EXPECT_LT(added, 0.7 * four) << "0.84 where mirrors are not moved";
}

TEST(Water, DeeperWaterShowsLessOfItsGround) {
    NoGlErrors errors;
    const TempDir folder;
    Project p = lake(folder);
    removeEntity(p, "cube");
    p.registry.get<Terrain>(findEntity(p, "ground"))->groundColor = {0.6f, 0.6f, 0.6f};
    p.registry.get<Water>(findEntity(p, "lake"))->color = {0, 0, 0};
    const ViewCamera c{{15, 6, 15}, {15, 0, 15.5}, 40, 0};
    float last = 1e9f;
    for (const float level : {0.1f, 0.5f, 1.0f, 2.0f}) {
        p.registry.get<Water>(findEntity(p, "lake"))->level = level;
        const std::vector<float> picture = drawn(p, c);
        const float middle = picture[3 * (kHeight / 2 * kWidth + kWidth / 2)];
        EXPECT_LT(middle, last) << level;
        last = middle;
    }
}

TEST(Water, TheMirroredViewIsDrawnOnlyWhileWaterIsSeen) {
    NoGlErrors errors;
    const TempDir folder;
    Project p = lake(folder);
    Renderer r(gpu(), tables());
    EXPECT_TRUE(holds(passesOf(r, p, ashore()), "mirrored objects/mesh"));
    EXPECT_FALSE(holds(passesOf(r, p, {{15, 2, 20}, {15, 30, 12}, 50, 0}), "mirrored objects/mesh")) << "looking up";
    EXPECT_FALSE(holds(passesOf(r, p, {{15, 0.3, 20}, {15, 0.3, 12}, 50, 0}), "mirrored objects/mesh"))
        << "under water";
    p.registry.get<Water>(findEntity(p, "lake"))->level = -3;
    EXPECT_FALSE(holds(passesOf(r, p, ashore()), "mirrored objects/mesh")) << "below all ground";
}

TEST(Water, WithoutReflectionNothingOfItIsRunOrHeld) {
    NoGlErrors errors;
    const TempDir folder;
    Project p = lake(folder);
    Renderer r(gpu(), tables());
    passesOf(r, p, ashore());
    EXPECT_GT(gpu().ledger.count("water/reflection"), 0u);
    p.registry.get<Water>(findEntity(p, "lake"))->reflection = 0;
    EXPECT_FALSE(holds(passesOf(r, p, ashore()), "mirrored objects/mesh"));
    EXPECT_EQ(gpu().ledger.count("water/reflection"), 0u);
    EXPECT_NE(r.explain(p, false).find("water-reflection: no Water has a reflection above 0"), std::string::npos);
}

TEST(Water, TheMirroredViewDrawsGrassCoarsely) {
    NoGlErrors errors;
    Project p = lawn();
    FlatField f = flatField(p, "grass");
    f.sliceWidth = f.sliceHeight = f.farSize = 32;
    put<Water>(p, "lake", {.level = 0.05f});
    Renderer r(gpu(), tables());
    const auto names = passesOf(r, p, eyeHeight());
    EXPECT_TRUE(holds(names, "mirrored grass/slices"));
    EXPECT_FALSE(holds(names, "mirrored grass/geometry"));
    EXPECT_FALSE(holds(names, "mirrored grass/ground-shadow"));
    EXPECT_TRUE(holds(names, "grass/geometry"));
    f.technique = nameOf(Technique::Tessellated);
    EXPECT_TRUE(holds(passesOf(r, p, eyeHeight()), "mirrored grass/tessellated"));
}

TEST(Water, MirrorsEveryFieldOfGrassAndLeavesTheMainViewAsItIs) {
    NoGlErrors errors;
    Project p = lawn();
    FlatField f = flatField(p, "grass");
    f.technique = nameOf(Technique::Geometry);
    FlatField other;
    other.technique = nameOf(Technique::Hybrid);
    other.sliceWidth = other.sliceHeight = other.farSize = 32;
    other.species[0].rootColor = other.species[0].midColor = other.species[0].tipColor = {0.4f, 0.02f, 0.02f};
    put(p, "other", other);
    put<Water>(p, "lake", {.level = 0.05f, .reflection = 1});
    Renderer r(gpu(), tables());
    const auto names = passesOf(r, p, eyeHeight());
    EXPECT_TRUE(holds(names, "mirrored grass/geometry"));
    EXPECT_TRUE(holds(names, "mirrored grass/slices"));
    // What is mirrored of the second field is red.
    const auto red = [&](Project& of) {
        double sum = 0;
        const std::vector<float> image = drawn(of, {{10, 1.2, 19}, {10, 0, 12}, 50, 0});
        for (size_t i = 0; i < image.size(); i += 3) sum += static_cast<double>(image[i] - image[i + 1]);
        return sum;
    };
    const double both = red(p);
    p.registry.get<Water>(findEntity(p, "lake"))->reflection = 0;
    const double unmirrored = red(p);
    p.registry.get<Water>(findEntity(p, "lake"))->reflection = 1;
    removeEntity(p, "other");
    const double first = red(p);
    p.registry.get<Water>(findEntity(p, "lake"))->reflection = 0;
    EXPECT_GT(std::abs((both - unmirrored) - (first - red(p))), 1) << "the mirror shows the second field";
}

// The mirrored view keeps cells and commands of its own: what the main one draws is made once.
TEST(Water, GrassInTheMirrorMakesNothingOfTheMainViewAnew) {
    NoGlErrors errors;
    Project p = lawn();
    FlatField f = flatField(p, "grass");
    f.sliceWidth = f.sliceHeight = f.farSize = 32;
    FlatField other;
    other.technique = nameOf(Technique::Geometry);  // whose blades are mirrored, as the first field's are not
    put(p, "other", other);
    other.technique = nameOf(Technique::Tessellated);
    put(p, "third", other);
    other.technique = nameOf(Technique::Raytraced);
    other.sliceWidth = other.sliceHeight = other.farSize = 32;
    put(p, "fourth", other);
    put<Water>(p, "lake", {.level = 0.05f});
    Renderer r(gpu(), tables());
    passesOf(r, p, eyeHeight());
    passesOf(r, p, eyeHeight());  // libepoxy has found every function by then
    CountGlCalls count;
    passesOf(r, p, eyeHeight());
    EXPECT_EQ(glCalls.byName["glCreateBuffers"], 0u) << glCallsByName();
    EXPECT_EQ(glCalls.byName["glCreateVertexArrays"], 0u);
    EXPECT_EQ(glCalls.textureUploads, 0u);
}

TEST(Water, NoValueOfAnyFieldMakesAPictureThatIsNoNumber) {
    NoGlErrors errors;
    const TempDir folder;
    Project p = lake(folder);
    put<Wind>(p, "wind", {.strength = 2, .speed = 100});
    Water& w = *p.registry.get<Water>(findEntity(p, "lake"));
    const auto sound = [&](const char* what) {
        for (const float v : drawn(p, ashore(), 1e9)) ASSERT_TRUE(std::isfinite(v) && v >= 0) << what;
    };
    w.clarity = 0.01f, sound("muddy");
    w.clarity = 10000, sound("clear");
    w.ripples = 2, w.rippleSize = 0.05f, sound("choppy");
    w.rippleSize = 1000, sound("a swell");
    w.reflection = 0.001f, sound("the smallest mirror");
    w.level = 1e5f, sound("above all");
    w.level = -1e5f, sound("below all");
    w.level = std::numeric_limits<float>::quiet_NaN(), sound("nowhere");
}

TEST(Water, PickingFindsTheGroundUnderIt) {
    const TempDir folder;
    Project p = lake(folder);
    const auto hit = pickGround(p, ashore(), kWidth, kHeight, kWidth / 2.0, kHeight - 5.0);
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->y, 0, 1e-6);
}

}  // namespace
}  // namespace sward::test
