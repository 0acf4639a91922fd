// The first pictures of who may wait: how few programs they take, and that nothing of them stays.
#include <algorithm>
#include <thread>

#include "fields.h"
#include "frame/draw_context.h"
#include "scenes.h"

namespace sward::test {
namespace {

// A lawn by all tiers, with shadows.
Project park() {
    Project p = lawn();
    FlatField f = flatField(p, "grass");
    f.technique = nameOf(Technique::Hybrid);
    f.species[0].bladesPerM2 = 2000;
    f.hybrid.minGeom = 2, f.hybrid.maxGeom = 4, f.hybrid.minBTF = 6, f.hybrid.maxBTF = 9;
    f.sliceWidth = f.farSize = 64, f.sliceHeight = 32;
    p.registry.get<Terrain>(findEntity(p, "ground"))->groundColor = {0.2f, 0.05f, 0.05f};
    return p;
}
ViewSettings quick(bool waits = true) {
    ViewSettings s = small();
    s.msaa = 1, s.detail = 0.25f, s.background = waits;
    return s;
}
double green(const std::vector<float>& pixels) {
    size_t n = 0;
    for (size_t i = 0; i < pixels.size(); i += 3) n += pixels[i + 1] > pixels[i];
    return 3.0 * static_cast<double>(n) / static_cast<double>(pixels.size());
}
bool has(const std::vector<std::string>& names, const char* name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}
bool waitsForPrograms(const Renderer& r) {
    for (const JobNews& j : r.jobs())
        if (j.label == "programs") return j.finished;
    return false;
}
void waitForJobs(const Renderer& r) {
    const auto busy = [](const JobNews& j) { return !j.finished; };
    for (std::vector<JobNews> jobs = r.jobs(); std::any_of(jobs.begin(), jobs.end(), busy); jobs = r.jobs())
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
}
ViewCamera across() { return {{10, 1.7, 1}, {10, 0, 6}, 50, 0}; }

TEST(Sketch, IsGrassGroundAndSkyByAFewPrograms) {
    NoGlErrors errors;
    const Project p = park();
    Renderer r(gpu(), tables());
    ASSERT_TRUE(r.draw(p, across(), quick()));
    const std::vector<std::string> names = r.programNames();
    for (const char* there : {"terrain/ground", "grass/far", "sky/dome", "post/tonemap"})
        EXPECT_TRUE(has(names, there)) << there;
    for (const char* later : {"grass/geometry", "grass/slices", "grass/ground-shadow", "grass/far-shadow"})
        EXPECT_FALSE(has(names, later)) << later;
    EXPECT_LE(names.size(), 6u);
    EXPECT_GT(green(r.readLinear()), 0.4) << "there is no grass in it";
    EXPECT_TRUE(waitsForPrograms(r)) << "nobody would draw the rest";
}

TEST(Sketch, TheOtherProgramsComeOneADrawAndThenThePictureIsAsItEverIs) {
    NoGlErrors errors;
    const Project p = park();
    Renderer r(gpu(), tables());
    ASSERT_TRUE(r.draw(p, across(), quick()));
    int draws = 0;
    for (size_t before = r.programNames().size(); waitsForPrograms(r) && draws < 20; ++draws) {
        ASSERT_TRUE(r.draw(p, across(), quick()));
        const size_t now = r.programNames().size();
        EXPECT_LE(now, before + 1) << "draw " << draws;
        before = now;
    }
    EXPECT_GE(draws, 4);
    EXPECT_LT(draws, 12);
    waitForJobs(r);
    ASSERT_TRUE(r.draw(p, across(), quick()));
    EXPECT_TRUE(r.jobs().empty());
    Renderer other(gpu(), tables());
    ASSERT_TRUE(other.draw(p, across(), quick(false)));
    EXPECT_EQ(r.readLinear(), other.readLinear());
    EXPECT_EQ(r.programNames(), other.programNames());
}

TEST(Sketch, BakesNothingBeforeThereIsSomethingToSee) {
    NoGlErrors errors;
    Project p = park();
    flatField(p, "grass").seed = 4711;  // not in the cache
    Renderer r(gpu(), tables());
    ASSERT_TRUE(r.draw(p, across(), quick()));
    ASSERT_EQ(r.jobs().size(), 1u) << r.jobs().back().label;
    EXPECT_EQ(r.jobs()[0].label, "programs");
}

TEST(Sketch, WhoDoesNotWaitOrWantsAllGetsAll) {
    NoGlErrors errors;
    const Project p = park();
    for (ViewSettings s : {quick(false), quick()}) {
        if (s.background) s.detail = 1;
        Renderer r(gpu(), tables());
        ASSERT_TRUE(r.draw(p, across(), s));
        EXPECT_TRUE(has(r.programNames(), "grass/geometry"));
        EXPECT_FALSE(waitsForPrograms(r));
    }
}

// Where no horizontal slice can stand for them, blades are in the first picture.
TEST(Sketch, BladesAloneDoNotWait) {
    NoGlErrors errors;
    Project p = park();
    flatField(p, "grass").technique = nameOf(Technique::Geometry);
    Renderer r(gpu(), tables());
    ASSERT_TRUE(r.draw(p, across(), quick()));
    EXPECT_TRUE(has(r.programNames(), "grass/geometry"));
    EXPECT_GT(green(r.readLinear()), 0.1);
}

}  // namespace
}  // namespace sward::test
