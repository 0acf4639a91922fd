// Frames of one sample that add up: as near to the truth as as many samples in one frame; nothing trails behind what
// moves; and nothing of it is there where it is not asked for.
#include "post/antialias.h"

#include <deque>

#include "fields.h"
#include "objects.h"
#include "pixels.h"
#include "reference/reference.h"
#include "scene/antialias.h"

namespace sward::test {
namespace {

using Pixels = std::vector<float>;

// Seconds a frame, and metres that a walker goes meanwhile.
constexpr double kFrame = 1.0 / 60, kStep = 1.4 * kFrame;
constexpr float kRounding = 1.0f / 1024;  // of colours up to 2, as halves: programs compiled otherwise round otherwise
constexpr int kAcross = 160, kDown = 120;

double distance(const Pixels& a, const Pixels& b) {
    double sum = 0;
    for (size_t i = 0; i < a.size(); ++i) sum += static_cast<double>((a[i] - b[i]) * (a[i] - b[i]));
    return std::sqrt(sum / static_cast<double>(a.size()));
}
float farthest(const Pixels& a, const Pixels& b) {
    float most = 0;
    for (size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
    return most;
}
// How much pixels differ within blocks of 4 x 4: the root mean square of green.
double contrast(const Pixels& a) {
    double sum = 0;
    for (size_t y = 0; y < kDown; y += 4)
        for (size_t x = 0; x < kAcross; x += 4) {
            double mean = 0, square = 0;
            for (size_t i = 0; i < 16; ++i) {
                const double v = static_cast<double>(a[((y + i / 4) * kAcross + x + i % 4) * 3 + 1]);
                mean += v / 16, square += v * v / 16;
            }
            sum += square - mean * mean;
        }
    return std::sqrt(sum);
}
// The distance from a traced picture, without the scatter of that one's own rays.
double distance(const Pixels& a, const Truth& truth) {
    const double own = distance(truth.error, Pixels(truth.error.size(), 0)), all = distance(a, truth.color);
    return std::sqrt(std::max(all * all - own * own, 0.0));
}
Truth traced(const Project& p, const ViewCamera& camera, double time) {
    JobControl control;
    auto scene = ReferenceScene::make(p, tables(), time, control);
    EXPECT_TRUE(scene);
    auto truth = scene->trace(
        camera, {.width = kAcross, .height = kDown, .samples = 64, .lighting = ReferenceLighting::Direct}, control);
    EXPECT_TRUE(truth);
    return std::move(*truth);
}

Project plainLawnBy(Technique t) {
    Project p = lawn();
    FlatField f = flatField(p, "grass");
    f.technique = nameOf(t);
    f.shadowMask = 0, f.groundShadows = false;
    return p;
}
ViewSettings samples(int msaa, glm::vec2 jitter = {0, 0}) {
    ViewSettings s = small();
    s.msaa = msaa, s.jitter = jitter;
    return s;
}
Pixels drawn(Renderer& r, const Project& p, const ViewCamera& c, const ViewSettings& s) {
    EXPECT_TRUE(r.draw(p, c, s));
    return r.readLinear();
}
// The mean of n x n frames of some samples, each moved to its part of the pixel.
Pixels meanOf(const Project& p, const ViewCamera& c, int n, int msaa, double time = 0) {
    Renderer r(gpu(), tables());
    Pixels sum(size_t{kAcross} * kDown * 3, 0);
    for (int i = 0; i < n * n; ++i) {
        ViewSettings s = samples(msaa, (glm::vec2(i % n, i / n) + 0.5f) / static_cast<float>(n) - 0.5f);
        s.time = time;
        const Pixels frame = drawn(r, p, c, s);
        for (size_t k = 0; k < sum.size(); ++k) sum[k] += frame[k] / static_cast<float>(n * n);
    }
    return sum;
}

TEST(Antialias, AtRestSixteenFramesAreAsGoodAsSixteenSamples) {
    NoGlErrors errors;
    for (const Technique t : {Technique::Geometry, Technique::Tessellated, Technique::Hybrid, Technique::Raytraced}) {
        Project p = plainLawnBy(t);
        const Truth truth = traced(p, eyeHeight(), 0);
        Renderer one(gpu(), tables());
        const double single = distance(drawn(one, p, eyeHeight(), samples(1)), truth),
                     sixteen = distance(meanOf(p, eyeHeight(), 2, 4), truth);
        setAntialias(p, Antialiasing::Temporal);
        Renderer r(gpu(), tables());
        const double first = distance(drawn(r, p, eyeHeight(), samples(4)), truth);
        int frames = 1;
        for (; r.addsUp(); ++frames) ASSERT_TRUE(r.draw(p, eyeHeight(), samples(4)));
        const double all = distance(r.readLinear(), truth);
        std::printf("%s: error of 1 sample %.4f, of 16 %.4f; of frames that add up: the first %.4f, all %.4f\n",
                    nameOf(t), single, sixteen, first, all);
        EXPECT_EQ(frames, 16);
        EXPECT_LT(all, 1.1 * sixteen) << nameOf(t);
        EXPECT_GT(single, 1.1 * sixteen) << nameOf(t) << ": the check can fail";
        EXPECT_GT(first, 1.1 * sixteen) << nameOf(t) << ": the check can fail";
    }
}

// --- what moves ------------------------------------------------------------------------------------------------------
// Frames up to one at `time` from a camera, each a step along `way` after the one before.
struct Walk {
    ViewCamera last;
    glm::dvec3 way{0};  // metres a frame
    double time = 2;
    int frames = 18;
    double seconds = kFrame;  // a frame
};
ViewSettings settingsAt(const Walk& f, int before, int msaa) {
    ViewSettings s = samples(msaa);
    s.time = f.time - f.seconds * before;
    return s;
}
ViewCamera cameraAt(const Walk& f, int before) {
    ViewCamera c = f.last;
    c.eye -= f.way * static_cast<double>(before), c.target -= f.way * static_cast<double>(before);
    return c;
}
Pixels lastOf(const Walk& f, Renderer& r, const Project& p) {
    for (int before = f.frames - 1; before >= 0; --before)
        EXPECT_TRUE(r.draw(p, cameraAt(f, before), settingsAt(f, before, 4)));
    return r.readLinear();
}
// The plain mean of the last frames, wherever things went meanwhile: what trails.
Pixels smeared(const Walk& f, const Project& p) {
    Renderer r(gpu(), tables());
    Pixels sum(size_t{kAcross} * kDown * 3, 0);
    for (int before = 15; before >= 0; --before) {
        const Pixels frame = drawn(r, p, cameraAt(f, before), settingsAt(f, before, 1));
        for (size_t k = 0; k < sum.size(); ++k) sum[k] += frame[k] / 16;
    }
    return sum;
}

// Where the truth is even around a pixel: how far a picture is from it at most, as a share of what lies between the
// thing that moves and what is behind it, and the share of such pixels that are off by more than an eighth.
struct Trail {
    double most = 0, share = 0;
};
Trail trail(const Pixels& picture, const Pixels& truth, double contrast) {
    Trail t;
    int even = 0, off = 0;
    const auto at = [](int x, int y) { return static_cast<size_t>((y * kAcross + x) * 3 + 1); };
    for (int y = 1; y + 1 < kDown; ++y)
        for (int x = 1; x + 1 < kAcross; ++x) {
            float low = 1e9f, high = 0;
            for (int v = -1; v <= 1; ++v)
                for (int u = -1; u <= 1; ++u)
                    low = std::min(low, truth[at(x + u, y + v)]), high = std::max(high, truth[at(x + u, y + v)]);
            if (static_cast<double>(high - low) > 0.05 * contrast) continue;
            const double by = static_cast<double>(std::abs(picture[at(x, y)] - truth[at(x, y)])) / contrast;
            t.most = std::max(t.most, by);
            ++even, off += by > 1.0 / 8;
        }
    t.share = static_cast<double>(off) / std::max(even, 1);
    return t;
}

// A picture n times as fine, each n x n pixels one.
Pixels downFrom(size_t n, const Project& p, const ViewCamera& c) {
    Renderer r(gpu(), tables());
    ViewSettings s = samples(4);
    s.width *= static_cast<int>(n), s.height *= static_cast<int>(n);
    const Pixels fine = drawn(r, p, c, s);
    Pixels out(size_t{kAcross} * kDown * 3, 0);
    for (size_t y = 0; y < n * kDown; ++y)
        for (size_t x = 0; x < n * kAcross; ++x)
            for (size_t k = 0; k < 3; ++k)
                out[(y / n * kAcross + x / n) * 3 + k] +=
                    fine[(y * n * kAcross + x) * 3 + k] / static_cast<float>(n * n);
    return out;
}

// The part of a picture in its middle.
Pixels middle(const Pixels& p) {
    Pixels out;
    for (int y = kDown / 3; y < kDown * 2 / 3; ++y) {
        const auto row = p.begin() + (y * kAcross) * 3;
        out.insert(out.end(), row + kAcross, row + 2 * kAcross);
    }
    return out;
}

// White lines of 15 cm over a lawn of the horizontal slice, half as wide as pixels: at rest and for who walks towards
// them they are as sharp as of many samples, and as bright.
TEST(Antialias, LinesOnTheGroundAreAsSharpAsOfManySamples) {
    Project p = lawn();
    FlatField f = flatField(p, "grass");
    f.technique = nameOf(Technique::Flat);
    f.species[0].bladesPerM2 = 3000;
    Map lines({400, 400, 4, PixelType::U8});
    for (int y = 0; y < 400; ++y)
        for (int x = 0; x < 400; ++x)
            for (int c = 0; c < 4; ++c) lines.set(x, y, c, c < 3 ? 0.9f : y % 60 < 3 || x % 60 < 2 ? 0.92f : 0.0f);
    p.registry.get<GrassField>(findEntity(p, "grass"))->vegetation = {"maps/lines.png", lines};
    const ViewCamera camera{{10, 26, -34}, {10, 0, 10}, 26, 0};
    const Pixels many = downFrom(4, p, camera), one = meanOf(p, camera, 1, 1);
    setAntialias(p, Antialiasing::Temporal);
    Renderer r(gpu(), tables());
    ASSERT_TRUE(r.draw(p, camera, samples(1)));
    while (r.addsUp()) ASSERT_TRUE(r.draw(p, camera, samples(1)));
    const Pixels rest = r.readLinear();
    Renderer walker(gpu(), tables());
    const glm::dvec3 way = glm::normalize(camera.target - camera.eye) * kStep;
    const Pixels walking = middle(lastOf({camera, way, 0}, walker, p)), lawn = middle(many);
    std::printf("lines: contrast of many samples %.3f, at rest %.3f, of one sample %.3f; brightness %.4f, %.4f, %.4f\n",
                contrast(many), contrast(rest), contrast(one), brightness(many), brightness(rest), brightness(one));
    std::printf("walking: distance %.4f, of one sample %.4f\n", distance(walking, lawn), distance(middle(one), lawn));
    EXPECT_LT(distance(walking, lawn), 0.6 * distance(middle(one), lawn)) << "one sample is the rival";
    EXPECT_NEAR(contrast(rest) / contrast(many), 1, 0.05);
    EXPECT_NEAR(brightness(rest) / brightness(many), 1, 0.02);
    EXPECT_LT(distance(rest, many), 0.5 * distance(one, many)) << "one sample is the rival";
}

TEST(Antialias, NothingTrailsBehindAnEdgeThatAWalkerPasses) {
    NoGlErrors errors;
    TempDir dir;
    Project p = lawn();
    p.registry.remove<GrassField>(findEntity(p, "grass"));
    p.dir = dir.path;
    putObject(p, "post", {{.color = {0.01f, 0.01f, 0.01f}}}, {10, 0, 4});
    const Walk aside{{{10, 1.2, 0}, {10, 0.9, 10}, 55, 0}, {kStep, 0, 0}};
    const Pixels truth = meanOf(p, aside.last, 4, 4, aside.time);
    const auto [low, high] = std::minmax_element(truth.begin(), truth.end());
    const double contrast = static_cast<double>(*high - *low) / 2;
    const double loses = trail(smeared(aside, p), truth, contrast).most;
    setAntialias(p, Antialiasing::Temporal);
    Renderer r(gpu(), tables());
    const double left = trail(lastOf(aside, r, p), truth, contrast).most;
    std::printf("trail behind a post, as a share of its contrast: %.4f; of frames that are not followed %.3f\n", left,
                loses);
    EXPECT_LT(left, 1.0 / 8);
    EXPECT_GT(loses, 1.0 / 8) << "the check can fail";
}

// The tables with passes that do not tell how far what they draw moved.
struct Unmoved {
    std::vector<EffectRow> effects;
    std::deque<std::vector<Pass>> passes;
    Tables all = tables();
    Unmoved() {
        for (EffectRow row : tables().effects) {
            std::vector<Pass>& copy = passes.emplace_back(row.passes.begin(), row.passes.end());
            for (Pass& p : copy) p.moves = false;
            row.passes = copy;
            effects.push_back(row);
        }
        all.effects = effects;
    }
};

TEST(Antialias, BladesAreFollowedByTheirOwnWind) {
    NoGlErrors errors;
    for (const Technique t : {Technique::Geometry, Technique::Tessellated, Technique::Slices, Technique::Raytraced}) {
        Project p = plainLawnBy(t);
        FlatField f = flatField(p, "grass");
        f.species[0].height = 0.5f;
        f.species[0].bladesPerM2 = 60;
        put<Wind>(p, "wind").strength = 1;
        const Walk stands{.last = {{10, 0.9, 9}, {10, 0.25, 11}, 20, 0}, .seconds = 1.0 / 15};
        const Pixels truth = meanOf(p, stands.last, 3, 4, stands.time);
        setAntialias(p, Antialiasing::Temporal);
        Renderer r(gpu(), tables());
        const Pixels seen = lastOf(stands, r, p);
        const double followed = distance(seen, truth);
        const Unmoved without;
        Renderer blind(gpu(), without.all);
        const Pixels unseen = lastOf(stands, blind, p);
        const double left = distance(unseen, truth);
        const Trail trails = trail(seen, truth, 0.2), drags = trail(unseen, truth, 0.2);
        std::printf(
            "%s in wind: error %.4f, trails over %.4f of even ground; without knowing how blades move %.4f, %.4f\n",
            nameOf(t), followed, trails.share, left, drags.share);
        EXPECT_LT(followed, 0.9 * left) << nameOf(t);
        if (!has(sceneFeatures(p.registry, tables()), Feature::GrassGeometry)) continue;  // no ground between slices
        EXPECT_LT(trails.share, 0.01) << nameOf(t);
        EXPECT_GT(drags.share, 0.1) << nameOf(t) << ": the check can fail";
    }
}

TEST(Antialias, WalkingInWindBeatsTheSamplesOfOneFrame) {
    NoGlErrors errors;
    Project p = plainLawnBy(Technique::Geometry);
    put<Wind>(p, "wind");
    const Walk walk{eyeHeight(), glm::normalize(glm::dvec3(1, 0, 1)) * kStep};
    const Truth truth = traced(p, walk.last, walk.time);
    Renderer plain(gpu(), tables());
    const double one = distance(drawn(plain, p, walk.last, settingsAt(walk, 0, 1)), truth),
                 four = distance(drawn(plain, p, walk.last, settingsAt(walk, 0, 4)), truth);
    setAntialias(p, Antialiasing::Temporal);
    Renderer r(gpu(), tables());
    const double walked = distance(lastOf(walk, r, p), truth);
    std::printf("walking in wind: error %.4f; of one frame of 1 sample %.4f, of 4 %.4f\n", walked, one, four);
    EXPECT_LT(walked, four);
    EXPECT_LT(four, one) << "the check can fail";
}

// Blades a pixel wide, near by: what is looked up between pixels frame after frame blurs. A mean of 16 frames, wherever
// they went, has 0.945 of the truth's contrast.
TEST(Antialias, NearBladesStaySharpForWhoWalksLowOverThem) {
    NoGlErrors errors;
    const ViewCamera low{{10, 0.25, 6}, {10, 0.1, 16}, 55, 0};
    const Walk walk{low, {0, 0, kStep}};
    Project p = plainLawnBy(Technique::Hybrid);
    FlatField f = flatField(p, "grass");
    f.minGeom = 1.5f, f.maxGeom = 3.5f;
    f.species[0].height = 0.05f, f.species[0].width = 0.006f, f.species[0].bladesPerM2 = 8000;
    const Pixels truth = meanOf(p, low, 4, 4, walk.time);
    Renderer plain(gpu(), tables());
    const double one = distance(drawn(plain, p, low, settingsAt(walk, 0, 1)), truth);
    setAntialias(p, Antialiasing::Temporal);
    Renderer r(gpu(), tables());
    const Pixels seen = lastOf(walk, r, p);
    const double sharp = contrast(seen) / contrast(truth), error = distance(seen, truth);
    std::printf("low over grass: %.3f of the truth's contrast, error %.4f, of one sample %.4f\n", sharp, error, one);
    EXPECT_NEAR(sharp, 1, 0.04);
    EXPECT_LT(error, 0.6 * one);
}

// --- where it is not
// ---------------------------------------------------------------------------------------------------
TEST(Antialias, LeavesNoTraceWhereItIsNotAskedFor) {
    NoGlErrors errors;
    Project p = lawn();
    put<Wind>(p, "wind");
    const auto seen = [&](Renderer& r) {
        EXPECT_TRUE(r.draw(p, eyeHeight(), small()));
        return std::tuple(r.explain(p, true), r.programNames(), gpu().ledger, r.readImage());
    };
    const auto never = [&] {
        Renderer fresh(gpu(), tables());
        return seen(fresh);
    }();
    Renderer r(gpu(), tables());
    setAntialias(p, Antialiasing::Temporal);
    const auto with = seen(r);
    EXPECT_NE(std::get<0>(with), std::get<0>(never));
    EXPECT_GT(std::get<2>(with).count("post/antialias"), 0u);
    setAntialias(p, Antialiasing::Msaa);
    removeEntity(p, "antialias");
    const auto after = seen(r);
    EXPECT_TRUE(std::get<0>(after) == std::get<0>(never));
    EXPECT_EQ(std::get<1>(after), std::get<1>(never));
    EXPECT_EQ(std::get<2>(after), std::get<2>(never));
    EXPECT_TRUE(std::get<3>(after) == std::get<3>(never));
}

TEST(Antialias, PiecesAndFalseColoursTakeTheirSamplesInOneFrame) {
    NoGlErrors errors;
    Project p = plainLawnBy(Technique::Hybrid);
    ViewSettings piece = small(), tiers = small();
    piece.width = 80, piece.part = {80, 0, 160, 120};
    tiers.mode = ViewMode::Tiers;
    Renderer plain(gpu(), tables());
    const Pixels piecePlain = drawn(plain, p, eyeHeight(), piece), tiersPlain = drawn(plain, p, eyeHeight(), tiers),
                 whole = drawn(plain, p, eyeHeight(), small());
    setAntialias(p, Antialiasing::Temporal);
    Renderer r(gpu(), tables());
    EXPECT_GT(farthest(drawn(r, p, eyeHeight(), small()), whole), 100 * kRounding) << "the check can fail";
    EXPECT_TRUE(r.addsUp());
    EXPECT_LT(farthest(drawn(r, p, eyeHeight(), piece), piecePlain), kRounding);
    EXPECT_FALSE(r.addsUp());
    EXPECT_LT(farthest(drawn(r, p, eyeHeight(), tiers), tiersPlain), kRounding);
}

TEST(Antialias, BegunAnewAPictureHoldsNothingOfTheOneBefore) {
    NoGlErrors errors;
    Project p = plainLawnBy(Technique::Geometry), other = plainLawnBy(Technique::Flat);
    for (Project* of : {&p, &other}) setAntialias(*of, Antialiasing::Temporal);
    Renderer fresh(gpu(), tables()), used(gpu(), tables());
    ASSERT_TRUE(drawSettled(fresh, p, eyeHeight(), small()));
    ASSERT_TRUE(drawSettled(used, other, eyeHeight(), small()));
    const Pixels before = used.readLinear();
    ASSERT_TRUE(drawSettled(used, p, eyeHeight(), small()));
    EXPECT_TRUE(used.readLinear() == fresh.readLinear());
    EXPECT_GT(distance(before, fresh.readLinear()), 0.001) << "the check can fail";
}

}  // namespace
}  // namespace sward::test
