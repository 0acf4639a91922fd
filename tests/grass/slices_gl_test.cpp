// Grass as slices against grass as blades: how much it covers, how bright it is, and what settings may change of that.
#include <fmt/format.h>

#include <chrono>
#include <numeric>
#include <thread>

#include "core/file.h"
#include "fields.h"
#include "frame/draw_context.h"
#include "missed.h"
#include "pixels.h"
#include "scenes.h"
#include "support.h"
#include "techniques.h"
#include "world/view_camera.h"

namespace sward::test {
namespace {

// A dense lawn with small slices, soil that is not green.
Project slicedMeadow(Technique technique) {
    Project p = lawn();
    FlatField f = flatField(p, "grass");
    f.technique = nameOf(technique);
    f.species[0].bladesPerM2 = 3000;
    f.sliceWidth = f.farSize = 64, f.sliceHeight = 32;
    p.registry.get<Terrain>(findEntity(p, "ground"))->groundColor = {0.2f, 0.05f, 0.05f};
    return p;
}
FlatField slicedGrass(Project& p) { return flatField(p, "grass"); }

ViewSettings slicedView(int msaa = 4) {
    ViewSettings s = small();
    s.msaa = msaa;
    return s;
}
// Across the lawn, steep enough that only ground and grass are seen.
ViewCamera across() { return {{10, 2.5, 1}, {10, 0, 4}, 40, 0}; }

std::vector<float> picture(Project& p, const ViewCamera& camera = across(),
                           const ViewSettings& settings = slicedView()) {
    Renderer r(gpu(), tables());
    const Status drawn = r.draw(p, camera, settings);
    EXPECT_TRUE(drawn) << drawn.error().text();
    return r.readLinear();
}
std::vector<float> picture(Project&& p, const ViewCamera& camera = across(),
                           const ViewSettings& settings = slicedView()) {
    return picture(p, camera, settings);
}
double rmse(const std::vector<float>& a, const std::vector<float>& b) {
    double sum = 0;
    for (size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
    return std::sqrt(sum / static_cast<double>(a.size()));
}

TEST(Slices, AllWaysToStoreThemGiveNearlyTheSamePicture) {
    NoGlErrors errors;
    for (const LightWeighting weights : {GrassSlices{}.lightWeights, LightWeighting::Atan})
        for (const Technique technique : {Technique::Slices, Technique::Flat}) {
            Project p = slicedMeadow(technique);
            slicedGrass(p).lightWeights = weights;
            const auto factored = picture(p);
            slicedGrass(p).lightWeights = LightWeighting::Atan;
            const auto interpolated = picture(p);  // what stands for the cosine in full storage
            slicedGrass(p).lightWeights = weights;
            for (const Storage storage : {Storage::Full, Storage::Compressed}) {
                slicedGrass(p).storage = storage;
                const auto other = picture(p);
                const auto& like = storage == Storage::Full ? interpolated : factored;
                const std::string which =
                    fmt::format("{}, {}, {}: {:.4f} apart, {:.3f} of its brightness",
                                kStorages[static_cast<int>(storage)], nameOf(technique), kLightWeights[weights],
                                rmse(other, like), brightness(other) / brightness(factored));
                std::printf("  %s\n", which.c_str());
                EXPECT_LT(rmse(other, like), 0.015) << which;
                EXPECT_NEAR(brightness(other), brightness(factored), 0.1 * brightness(factored)) << which;
            }
        }
}

// At night by one lamp: what is stored in full is lit by it as what is factored.
TEST(Slices, AreLitByALampHoweverTheyAreStored) {
    NoGlErrors errors;
    for (const Technique technique : {Technique::Slices, Technique::Flat}) {
        Project p = slicedMeadow(technique);
        p.registry.get<Light>(findEntity(p, "sun"))->elevationDeg = -20;
        Light lamp;
        lamp.type = LightType::Point, lamp.intensity = 30;
        put(p, "lamp", lamp);
        put<Transform>(p, "lamp", {{10, 2, 5}});
        const auto factored = picture(p);
        p.registry.get<Light>(findEntity(p, "lamp"))->intensity = 0;
        const double dark = brightness(picture(p));
        EXPECT_GT(brightness(factored), 2 * dark) << nameOf(technique);
        p.registry.get<Light>(findEntity(p, "lamp"))->intensity = 30;
        slicedGrass(p).storage = Storage::Full;
        const double share = (brightness(picture(p)) - dark) / (brightness(factored) - dark);
        std::printf("  %s: full storage has %.3f of the lamp's light\n", nameOf(technique), share);
        EXPECT_NEAR(share, 1, 0.1) << nameOf(technique);
    }
}

TEST(Slices, CoverAndShineAboutAsTheBladesThatTheyStandFor) {
    NoGlErrors errors;
    const auto blades = picture(slicedMeadow(Technique::Geometry));
    for (const Technique technique : {Technique::Slices, Technique::Flat}) {
        const auto slices = picture(slicedMeadow(technique));
        EXPECT_NEAR(covered(slices), covered(blades), 0.12) << nameOf(technique);
        const double off = std::abs(brightness(slices) / brightness(blades) - 1);
        std::printf("  %s: %.3f of the blades' cover, brightness off by %.3f\n", nameOf(technique),
                    covered(slices) / covered(blades), off);
        // Blades have 1.00 of the truth's light here, slices and the horizontal one 1.15 to 1.18; of images as large as
        // those that ship, slices 1.10 and rays 1.01.
        expectMissed(fmt::format("brightness of {} against blades', from steeply above", nameOf(technique)), off, 0.12,
                     technique == Technique::Flat ? 0.146 : 0.166);
    }
}

TEST(Slices, EachWayWithPartCoveredPixelsCovers) {
    NoGlErrors errors;
    Project bare = slicedMeadow(Technique::Slices);
    bare.registry.remove<GrassField>(findEntity(bare, "grass"));
    EXPECT_LT(covered(picture(bare)), 0.001);
    const auto blades = picture(slicedMeadow(Technique::Geometry));
    for (size_t way = 0; way < std::size(kTransparencies); ++way) {
        Project p = slicedMeadow(Technique::Slices);
        slicedGrass(p).transparency = static_cast<Transparency>(way);
        const auto drawn = picture(p);
        // Blended nearest first, what lies behind is lost: 0.36 of the pixels show grass.
        const double lacks = 1 - covered(drawn) / covered(blades);
        if (static_cast<Transparency>(way) == Transparency::Blend)
            expectMissed("of what blades cover blended slices do not", lacks, 0.2, 0.2045);
        else
            EXPECT_LT(lacks, 0.2) << kTransparencies[way];
        EXPECT_NEAR(brightness(drawn), brightness(blades), 0.25 * brightness(blades)) << kTransparencies[way];
    }
}

TEST(Slices, AreAsBrightWithAnyNumberOfSamples) {
    NoGlErrors errors;
    const double four = brightness(picture(slicedMeadow(Technique::Slices), across(), slicedView(4)));
    for (const int samples : {1, 2})
        EXPECT_NEAR(brightness(picture(slicedMeadow(Technique::Slices), across(), slicedView(samples))), four,
                    0.03 * four)
            << samples;
}

TEST(Slices, OnAHillStandOnTheGroundWithoutGaps) {
    NoGlErrors errors;
    const auto hill = [](Technique technique) {
        Project p = slicedMeadow(technique);
        Map m({64, 64, 1, PixelType::F32});
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 64; ++x)
                m.set(x, y, 0, 0.4f * std::sin(0.3f * static_cast<float>(x)) + 0.05f * static_cast<float>(y));
        p.registry.get<Terrain>(findEntity(p, "ground"))->height = field(m);
        return p;
    };
    const ViewCamera camera{{10, 4, 1}, {10, 0.5, 5}, 40, 0};
    const double flat = covered(picture(slicedMeadow(Technique::Slices), camera)) /
                        covered(picture(slicedMeadow(Technique::Geometry), camera));
    const double hilly =
        covered(picture(hill(Technique::Slices), camera)) / covered(picture(hill(Technique::Geometry), camera));
    EXPECT_NEAR(hilly, flat, 0.15);
    EXPECT_GT(covered(picture(hill(Technique::Flat), camera)),
              0.8 * covered(picture(hill(Technique::Geometry), camera)));
}

TEST(Slices, PaintedLeanChangesTheirBrightnessAsItDoesThatOfBlades) {
    NoGlErrors errors;
    const auto change = [](Technique technique) {
        const auto leant = [&](float x) {
            Project p = slicedMeadow(technique);
            FlatField f = slicedGrass(p);
            f.species[0].leanDeg = 25;
            Map m({4, 4, 2, PixelType::U16});
            for (int i = 0; i < 16; ++i) m.set(i % 4, i / 4, 0, x), m.set(i % 4, i / 4, 1, 0.5f);
            f.orientation = field(m);
            *p.registry.get<Light>(findEntity(p, "sun")) = {.azimuthDeg = 90, .elevationDeg = 35};
            return brightness(picture(p));  // the light comes from the side: as much soil is seen either way
        };
        const double towards = leant(1), away = leant(0);
        return (towards - away) / (towards + away);
    };
    const double blades = change(Technique::Geometry);
    EXPECT_GT(std::abs(blades), 0.01);
    for (const Technique technique : {Technique::Slices, Technique::Flat}) {
        const double slices = change(technique);
        EXPECT_GT(slices * blades, 0) << "technique " << nameOf(technique) << ": " << slices << ", blades: " << blades;
    }
}

// Mean colour inside a disc of three metres that something pressed flat, seen from a distance.
glm::dvec3 pressedColor(Technique technique, const Light& sun, double distance) {
    Project p = slicedMeadow(technique);
    slicedGrass(p).species[0].bladesPerM2 = 1200;
    *p.registry.get<Light>(findEntity(p, "sun")) = sun;
    ForceSource disc;
    disc.radius = 3;
    put(p, "disc", disc);
    put<Transform>(p, "disc", {{10, 0, 10}});
    const auto pixels = picture(p, {{10, 1.7, 9.6 + std::sqrt(distance * distance - 1.7 * 1.7)},
                                    {10, 0, 9.6},
                                    static_cast<float>(40 / distance),
                                    0});
    glm::dvec3 sum(0);
    for (size_t i = 0; i < pixels.size(); i += 3) sum += glm::dvec3(pixels[i], pixels[i + 1], pixels[i + 2]);
    return sum * (3.0 / static_cast<double>(pixels.size()));
}

// By how much the limit was missed when it was last looked at: between blades that lie, soil is seen in the light that
// comes to it, and slices cover it. 0: it is kept.
double missedGreen(Technique technique, double distance, double elevationDeg) {
    const bool high = elevationDeg > 30, near = distance < 5;
    if (technique == Technique::Slices) return near ? (high ? 0.714 : 0.669) : (high ? 0 : 0.578);
    if (high) return near ? 0.614 : 0;
    return near ? 0.889 : 0.792;
}

TEST(Slices, WhereTheyArePressedTheGroundIsAsGreenAsUnderBladesThatLie) {
    NoGlErrors errors;
    const Light behind{.azimuthDeg = 135, .elevationDeg = 40}, against{.azimuthDeg = 0, .elevationDeg = 20};
    for (const Light& sun : {behind, against})
        for (const double distance : {2.5, 8.0}) {
            const glm::dvec3 blades = pressedColor(Technique::Geometry, sun, distance);
            for (const Technique technique : {Technique::Slices, Technique::Flat}) {
                const glm::dvec3 share = pressedColor(technique, sun, distance) / blades;
                const std::string which =
                    fmt::format("{}, {} m, sun at {} degrees: {:.2f} of the blades' red, {:.2f} of their green",
                                nameOf(technique), distance, sun.elevationDeg, share.x, share.y);
                std::printf("  %s\n", which.c_str());
                if (distance > 5 && sun.elevationDeg < 30)
                    expectMissed("brightness of pressed grass against blades': " + which, share.y - 1, 0.45,
                                 technique == Technique::Flat ? 0.768 : 0.669);
                else
                    EXPECT_NEAR(share.y, 1, 0.45) << which;
                const double known = missedGreen(technique, distance, static_cast<double>(sun.elevationDeg));
                if (known > 0)
                    expectMissed("pressed grass' green by its red against blades': " + which, share.y / share.x - 1,
                                 0.35, known);
                else
                    EXPECT_NEAR(share.y / share.x, 1, 0.35) << which << "; soil is red";
            }
        }
}

TEST(Slices, AreMadeBesideWithADraftShownUntilTheyAreThere) {
    const EmptyCache cache;
    NoGlErrors errors;
    Project p = slicedMeadow(Technique::Slices);
    slicedGrass(p).drawing.bakeLight = BakeLight::Local;  // which makes nothing else beside
    slicedGrass(p).seed = 7;
    slicedGrass(p).sliceWidth = slicedGrass(p).farSize = 512;
    ViewSettings beside = slicedView();
    beside.background = true;
    Renderer r(gpu(), tables());
    ASSERT_TRUE(r.draw(p, across(), beside));
    const auto draft = r.readLinear();
    EXPECT_GT(covered(draft), 0.1) << "nothing is shown meanwhile";
    ASSERT_EQ(r.jobs().size(), 1u);
    EXPECT_EQ(r.jobs()[0].label, "slices of lawn");
    while (!r.jobs()[0].finished) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    EXPECT_EQ(r.jobs()[0].progress, 1);
    ASSERT_TRUE(r.draw(p, across(), beside));
    EXPECT_TRUE(r.jobs().empty());
    EXPECT_GT(rmse(r.readLinear(), draft), 0);
    EXPECT_EQ(r.readLinear(), picture(p)) << "not what one gets who waits";
}

TEST(Slices, ABakeForOtherBladesIsCancelledAndCachedOnesComeAtOnce) {
    const EmptyCache cache;
    NoGlErrors errors;
    Project p = slicedMeadow(Technique::Slices);
    slicedGrass(p).drawing.bakeLight = BakeLight::Local;
    const auto known = picture(p);  // in the cache from here on
    ViewSettings beside = slicedView();
    beside.background = true;
    Renderer r(gpu(), tables());
    ASSERT_TRUE(r.draw(p, across(), beside));
    EXPECT_TRUE(r.jobs().empty());
    EXPECT_EQ(r.readLinear(), known);
    for (const float height : {0.2f, 0.25f}) {
        slicedGrass(p).species[0].height = height;
        ASSERT_TRUE(r.draw(p, across(), beside));
        EXPECT_EQ(r.jobs().size(), 1u) << "one at a time";
    }
    slicedGrass(p).species[0].height = 0.15f;
    ASSERT_TRUE(r.draw(p, across(), beside));
    EXPECT_TRUE(r.jobs().empty()) << "made for blades that are gone";
    EXPECT_EQ(r.readLinear(), known);
}

// Quads of one opacity, one over the other, by lib/transparency.glsl.
class Layers {
  public:
    Layers() {
        std::filesystem::copy(std::filesystem::path(SWARD_SOURCE_DIR) / "shaders", dir.path,
                              std::filesystem::copy_options::recursive);
        writeText(dir / "test/layers.vert.glsl",
                  "flat out int layer;\nvoid main() {\n    layer = gl_InstanceID;\n    gl_Position = vec4(gl_VertexID "
                  "% 2 * 4 - 1, gl_VertexID / 2 * 4 - 1, 0.5, 1.0);\n}\n");
        writeText(dir / "test/layers.frag.glsl",
                  "#include \"lib/transparency.glsl\"\n#include \"numerics/hash.h\"\n"
                  "layout(location = 0) uniform float alpha;\nflat in int layer;\nout vec4 color;\nvoid main() {\n"
                  "    float a = coveredAlpha(COVERAGE, alpha, hash3(uint(gl_FragCoord.x), uint(gl_FragCoord.y), "
                  "uint(layer)));\n"
                  "    if (!(a > 0.0)) discard;\n    color = vec4(1.0, 1.0, 1.0, a);\n}\n");
    }
    // Share of a black picture that n layers hide.
    double hidden(float alpha, int n, int samples) {
        const GLuint program = *programs.get({"test/layers", "test/layers.vert.glsl", "test/layers.frag.glsl", nullptr},
                                             "const bool TEMPORAL = false;\n");
        FrameGlobals globals{};
        globals.samples = samples;
        const Buffer frame = makeBuffer(gpu(), "test", sizeof(globals), &globals);
        const Texture color = makeTexture2DMultisample(gpu(), "test", GL_RGBA16F, kSide, kSide, samples),
                      plain = makeTexture2D(gpu(), "test", GL_RGBA16F, kSide, kSide);
        const Framebuffer target = makeFramebuffer(color.id(), 0, "test"),
                          resolved = makeFramebuffer(plain.id(), 0, "test");
        const VertexArray none = makeVertexArray("test");
        glBindFramebuffer(GL_FRAMEBUFFER, target.id());
        glViewport(0, 0, kSide, kSide);
        glDisable(GL_DEPTH_TEST);
        glDisable(GL_BLEND);
        glEnable(GL_MULTISAMPLE);
        glClearColor(0, 0, 0, 0);
        glClear(GL_COLOR_BUFFER_BIT);
        glBindBufferBase(GL_UNIFORM_BUFFER, UBO_FRAME, frame.id());
        glUseProgram(program);
        glUniform1f(0, alpha);
        glBindVertexArray(none.id());
        glDrawArraysInstanced(GL_TRIANGLES, 0, 3, n);
        glBlitNamedFramebuffer(target.id(), resolved.id(), 0, 0, kSide, kSide, 0, 0, kSide, kSide, GL_COLOR_BUFFER_BIT,
                               GL_NEAREST);
        std::vector<float> pixels(kSide * kSide);
        glGetTextureImage(plain.id(), 0, GL_RED, GL_FLOAT, static_cast<GLsizei>(pixels.size() * sizeof(float)),
                          pixels.data());
        glBindVertexArray(0);
        glUseProgram(0);
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        return std::accumulate(pixels.begin(), pixels.end(), 0.0) / static_cast<double>(pixels.size());
    }

  private:
    static constexpr int kSide = 128;
    TempDir dir;
    Programs programs{dir.path};
};

TEST(Transparency, LayersOfSamplesHideWhatTheirOpacitySays) {
    NoGlErrors errors;
    gpu();
    Layers layers;
    for (const int samples : {1, 2, 4})
        for (const float alpha : {0.05f, 0.1f, 0.3f, 0.5f, 0.9f, 1.0f})
            for (const int n : {1, 4, 16})
                EXPECT_NEAR(layers.hidden(alpha, n, samples), 1 - std::pow(1 - alpha, n), 0.02)
                    << n << " layers of " << alpha << ", " << samples << " samples";
}

// The horizontal slices of several species lie over each other: which is listed first must not decide which hides the
// other.
TEST(Slices, TallGrassHidesLowGrassWhicheverIsListedFirst) {
    NoGlErrors errors;
    const auto redness = [](bool tallFirst) {
        Project p = slicedMeadow(Technique::Flat);
        FlatField f = slicedGrass(p);
        Species low = f.species[0], tall = f.species[0];
        low.name = "low", low.height = 0.05f;
        tall.name = "tall", tall.height = 0.5f;
        tall.rootColor = tall.midColor = tall.tipColor = {0.4f, 0.05f, 0.05f};
        f.species = tallFirst ? std::vector{tall, low} : std::vector{low, tall};
        const auto pixels = picture(p);
        double red = 0, green = 0;
        for (size_t k = 0; k < pixels.size(); k += 3) red += pixels[k], green += pixels[k + 1];
        return red / green;
    };
    const double first = redness(true), last = redness(false);
    EXPECT_GT(last, 2) << "the tall grass is red";
    EXPECT_NEAR(first, last, 0.05 * last);
}

}  // namespace
}  // namespace sward::test
