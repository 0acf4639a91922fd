// Cells chosen by the GPU: the CPU's, cell for cell and in the same order; the same pictures; and what a frame hands
// over.
#include "grass/gpu_cells.h"

#include <regex>
#include <set>

#include "fields.h"
#include "gl_calls.h"
#include "grass/comparison.h"
#include "scene/antialias.h"
#include "scenes.h"
#include "support.h"
#include "techniques.h"
#include "world/view_camera.h"

namespace sward::test {
namespace {

Map waves(int side) {
    Map m({side, side, 1, PixelType::U16});
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            m.set(x, y, 0,
                  std::clamp(
                      0.6f * std::sin(static_cast<float>(x) * 0.31f) * std::cos(static_cast<float>(y) * 0.23f) + 0.4f,
                      0.0f, 1.0f));
    return m;
}
Map hills() {
    Map m({64, 64, 1, PixelType::F32});
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            m.set(x, y, 0, 3 * std::sin(static_cast<float>(x) * 0.2f) * std::cos(static_cast<float>(y) * 0.15f));
    return m;
}

Project meadow(Technique technique, bool painted) {
    Project p = lawn();
    Terrain& t = *p.registry.get<Terrain>(findEntity(p, "ground"));
    t.size = {43.3, 37.7};  // its last cells are cut
    FlatField f = grassIn(p);
    f.technique = nameOf(technique);
    f.drawing.bakeLight = BakeLight::Local;  // cells are chosen in any light
    f.minGeom = 3, f.maxGeom = 9;
    f.maxDistance = 22, f.thinning = 0.6f, f.leastPixels = 0.4f;
    f.sliceWidth = f.sliceHeight = f.farSize = 16;
    f.species[0].bladesPerM2 = 90;
    if (!painted) return p;
    t.height = {"maps/h.exr", hills()};
    f.species[0].density = {"maps/d.png", waves(57)};
    return p;
}
std::vector<uint8_t> pictureOf(Renderer& r, Project& p, Culling culling, const ViewCamera& c) {
    grassIn(p).culling = culling;
    ViewSettings s = small();
    s.measure = true;
    const Status drawn = r.draw(p, c, s);
    EXPECT_TRUE(drawn) << (drawn ? "" : drawn.error().text());
    return r.readImage();
}

void expectPicturesOfTheCpu(Technique technique, bool painted) {
    NoGlErrors errors;
    Renderer cpu(gpu(), tables()), own(gpu(), tables());
    Project p = meadow(technique, painted);
    for (const ViewCamera& view : {eyeHeight(), ViewCamera{{43, 1, 37}, {0, 0, 0}, 40, 0}}) {
        const auto expected = pictureOf(cpu, p, Culling::Cpu, view), found = pictureOf(own, p, Culling::Gpu, view);
        EXPECT_TRUE(expected == found) << nameOf(technique) << " painted " << painted;
        if (technique != Technique::Tessellated) continue;  // elsewhere the CPU lists blades
        EXPECT_EQ(cpu.stats().cells, own.stats().cells);
        EXPECT_EQ(cpu.stats().bladesGeometry, own.stats().bladesGeometry);
        EXPECT_GT(own.stats().cells, 5u);
    }
}
TEST(GpuCells, PicturesAndCountsAreTheCpus) { expectPicturesOfTheCpu(Technique::Tessellated, true); }
TEST(GpuCells, PicturesAreTheCpusOfTheHybridAndWithoutPaintToo) {
    expectPicturesOfTheCpu(Technique::Tessellated, false);
    for (const bool painted : {false, true}) expectPicturesOfTheCpu(Technique::Hybrid, painted);
}

// In each frame other blades of those that fade are there: the lists of the CPU follow.
TEST(GpuCells, PicturesOfFramesThatAddUpAreTheCpus) {
    NoGlErrors errors;
    Renderer cpu(gpu(), tables()), own(gpu(), tables());
    Project p = meadow(Technique::Geometry, true);
    setAntialias(p, Antialiasing::Temporal);
    for (int frame = 0; frame < 4; ++frame)
        EXPECT_TRUE(pictureOf(cpu, p, Culling::Cpu, eyeHeight()) == pictureOf(own, p, Culling::Gpu, eyeHeight()))
            << "frame " << frame;
}

TEST(GpuCells, CountsAreThisFramesWhereThatIsAskedFor) {
    NoGlErrors errors;
    for (const Technique technique : {Technique::Tessellated, Technique::Geometry}) {
        Renderer r(gpu(), tables());
        Project p = meadow(technique, false);
        grassIn(p).culling = Culling::Gpu;
        ViewSettings s = small();
        const auto blades = [&](bool asked, bool bare) {
            grassIn(p).species[0].bladesPerM2 = bare ? 0 : 100;
            s.counted = asked;
            EXPECT_TRUE(r.draw(p, eyeHeight(), s));
            return r.stats().bladesGeometry;
        };
        const uint64_t all = blades(true, false);
        EXPECT_GT(all, 100u) << nameOf(technique) << ", in the first frame";
        EXPECT_EQ(blades(true, true), 0u);
        EXPECT_EQ(blades(true, false), all);
    }
}

TEST(GpuCells, ASpeciesWithoutADensityMapGrowsEverywhereWhateverAnothersMap) {
    NoGlErrors errors;
    for (const Technique technique : {Technique::Tessellated, Technique::Hybrid})
        for (const Culling culling : {Culling::Gpu, Culling::Cpu}) {
            Project p = meadow(technique, true);
            FlatField f = grassIn(p);
            f.species.push_back(f.species[0]);
            f.species[1].name = "low", f.species[1].height *= 0.5f;
            Map ones({8, 8, 1, PixelType::U8});
            for (int i = 0; i < 64; ++i) ones.set(i % 8, i / 8, 0, 1);
            f.species[1].density = {"maps/ones.png", ones};
            Renderer painted(gpu(), tables()), bare(gpu(), tables());
            const auto expected = pictureOf(painted, p, culling, eyeHeight());
            f.species[1].density = {};
            for (int frame = 0; frame < 2; ++frame)
                EXPECT_TRUE(expected == pictureOf(bare, p, culling, eyeHeight()))
                    << nameOf(technique) << " " << kCullings[static_cast<size_t>(culling)] << " frame " << frame;
            // Where there is a map, blades that the CPU lists are those that may be there: roundings of the GPU's
            // included.
            EXPECT_GE(painted.stats().bladesGeometry, bare.stats().bladesGeometry);
            EXPECT_LE(painted.stats().bladesGeometry, bare.stats().bladesGeometry * 1.001);
        }
}

TEST(GpuCells, StagesDrawWhatWasChosenAsWell) {
    NoGlErrors errors;
    Project p = meadow(Technique::Tessellated, true);
    grassIn(p).tessellation = Tessellation::Stages;
    Renderer cpu(gpu(), tables()), own(gpu(), tables());
    EXPECT_TRUE(pictureOf(cpu, p, Culling::Cpu, eyeHeight()) == pictureOf(own, p, Culling::Gpu, eyeHeight()));
}

TEST(GpuCells, TheSameFrameIsTheSamePictureAgain) {
    Project p = meadow(Technique::Tessellated, true);
    Renderer r(gpu(), tables());
    const auto first = pictureOf(r, p, Culling::Gpu, eyeHeight());
    pictureOf(r, p, Culling::Gpu, {{20, 6, 20}, {24, 0, 23}, 70, 0});
    EXPECT_TRUE(first == pictureOf(r, p, Culling::Gpu, eyeHeight()));
}

// Cells chosen by the CPU's selectCells and by the shader, without anything that is drawn.
class Chosen : public ::testing::Test {
  protected:
    Terrain terrain;
    FlatField field;
    HeightBounds bounds;
    Patch patch;
    Programs programs;
    MapTextures maps{gpu()};

    std::vector<CellDraw> byGpu(const CellQuery& q) {
        const std::vector<CellNode> nodes = selectNodes(q);
        ChosenCells c;
        c.byGpu = c.counting = true;
        c.count = static_cast<uint32_t>(nodes.size()) * 64;
        const CullGlobals globals = cullGlobals({q, 1, 1, 1, 1e30f, 256, true});
        c.globals = makeBuffer(gpu(), "test", sizeof(globals), &globals);
        c.nodes = makeBuffer(gpu(), "test", nodes.size() * sizeof(CellNode), nodes.data());
        c.chosen = makeBuffer(gpu(), "test", c.count * sizeof(ChosenCell), nullptr);
        c.upTo = makeBuffer(gpu(), "test", sizeof(patch.upTo), patch.upTo.data());
        c.counts = makeBuffer(gpu(), "test", sizeof(ChosenCounts), nullptr);
        const auto program =
            programs.get({.name = "test/choice", .compute = "grass/cells.comp.glsl"},
                         q.density ? "const bool GRASS_DENSITY = true;\n" : "const bool GRASS_DENSITY = false;\n");
        EXPECT_TRUE(program) << (program ? "" : program.error().text());
        if (!program) return {};
        glUseProgram(*program);
        runChoice(c, q.density ? maps.get("test", "density", *q.density) : 0);
        std::vector<ChosenCell> cells(c.count);
        glGetNamedBufferSubData(c.chosen.id(), 0, static_cast<GLsizeiptr>(c.count * sizeof(ChosenCell)), cells.data());
        std::vector<CellDraw> out;
        for (const ChosenCell& cell : cells) {
            const uint32_t blades = cell.bits & ((1u << CHOSEN_LEVEL) - 1);
            if (blades == 0) continue;
            CellDraw d{};
            d.cellX = cell.cell.x, d.cellZ = cell.cell.y, d.first = cell.first, d.last = cell.first + blades;
            d.segments = static_cast<int>(cell.bits >> CHOSEN_LEVEL & 127),
            d.whole = static_cast<int>(cell.bits >> CHOSEN_WHOLE & 1),
            d.seen = static_cast<int>(cell.bits >> CHOSEN_SEEN & 1);
            out.push_back(d);
        }
        return out;
    }
    void expectSame(const CellQuery& q, const std::string& what) {
        const std::vector<CellDraw> a = selectCells(q), b = byGpu(q);
        ASSERT_EQ(a.size(), b.size()) << what;
        for (size_t i = 0; i < a.size(); ++i) {
            const auto look = [](const CellDraw& c) {
                return std::tuple(c.cellX, c.cellZ, c.first, c.last, c.segments, c.whole, c.seen);
            };
            ASSERT_TRUE(look(a[i]) == look(b[i]))
                << what << ", cell " << a[i].cellX << " " << a[i].cellZ << " and " << b[i].cellX << " " << b[i].cellZ;
        }
    }
};

TEST_F(Chosen, CellsAreTheCpusInTheSameOrderFromAnywhere) {
    NoGlErrors errors;
    uint32_t h = 7;
    const auto random = [&](double low, double high) {
        return low + (high - low) * f32::hashUnit(h = f32::hashMix(h));
    };
    uint64_t cells = 0;
    for (int i = 0; i < 60; ++i) {
        const bool painted = i % 2 == 1, tessellated = i % 3 == 0;
        const double side = i % 5 == 4 ? 90000 : random(5, 120), range = random(5, 60);
        terrain.size = {side, side * random(0.6, 1)};
        terrain.height = painted ? MapField{"maps/h.exr", hills()} : MapField{};
        updateHeightBounds(bounds, terrain);
        field.cellSize = static_cast<float>(random(0.2, 2));
        field.technique = nameOf(tessellated ? Technique::Tessellated : Technique::Hybrid);
        field.maxDistance = static_cast<float>(range), field.minGeom = static_cast<float>(range / 3),
        field.maxGeom = static_cast<float>(range);
        field.species[0].bladesPerM2 = 40;
        field.species[0].density = painted ? MapField{"maps/d.png", waves(50 + i)} : MapField{};
        patch = makePatch(field.species[0], field.cellSize, 1);
        const glm::dvec3 eye(random(0, terrain.size.x), random(0.3, 12), random(0, terrain.size.y));
        const Frustum frustum = frustumOf(
            viewProjection({eye, eye + glm::dvec3(random(-1, 1), random(-0.8, 0.2), random(-1, 1)), 60, 0}, 320, 240));
        CellQuery q = cellQuery(queryOf(terrain, bounds, field, patch), {eye, frustum, 300});
        if (tessellated)
            q.levels = {6, field.maxDistance, i % 2 ? 40.0f : 0.0f, q.reach},
            q.thinning = {0.5f / field.maxDistance, i % 3 ? 1e30f : 7};
        else
            q.shadow = static_cast<float>(random(0, 2));
        expectSame(q, "view " + std::to_string(i));
        if (HasFatalFailure()) return;
        cells += selectCells(q).size();
    }
    EXPECT_GT(cells, 5000u);
}

Project million() {
    Project p = designed({"a million blades", 1100, 0.3f, 0.012f, 32.25, 0, 0, 0, 0}, 32.25);
    FlatField f = grassIn(p);
    f.technique = nameOf(Technique::Tessellated);
    f.beyond = Beyond::Nothing;
    f.maxDistance = 60, f.thinning = 0, f.lowerFrom = 1;
    f.shadowMask = 0;
    give(p, "wind", Wind{});
    give(p, "roller", ForceSource{});
    p.registry.add<Transform>(findEntity(p, "roller"), Transform{{16, 0, 10}});
    return p;
}

TEST(GpuCells, AMillionBladesAreFewCallsAndLittleUpload) {
    const ViewCamera edge{{16, 1.7, -14}, {16, 0, 16}, 55, 0};
    ViewSettings s = small();
    s.width = 64, s.height = 48, s.msaa = 1;
    for (const Culling culling : {Culling::Gpu, Culling::Cpu}) {
        Renderer r(gpu(), tables());
        Project p = million();
        grassIn(p).cellSize = 0.75f;
        grassIn(p).culling = culling;
        for (int i = 0; i < 2; ++i) {  // libepoxy has found every function by then
            s.measure = i == 0;
            ASSERT_TRUE(r.draw(p, edge, s));
            if (s.measure) EXPECT_GT(r.stats().bladesGeometry, 1000000u);
        }
        s.time = 0.5;
        CountGlCalls count;
        ASSERT_TRUE(r.draw(p, edge, s));
        EXPECT_LE(glCalls.calls, 97u) << "with three more where the chosen cells are counted, at most 100\n"
                                      << glCallsByName();
        EXPECT_LE(glCalls.bytes, culling == Culling::Gpu ? 4096u : 65536u);
        EXPECT_EQ(glCalls.textureUploads, 0u);
        EXPECT_EQ(glCalls.reads, 0u) << "nothing is read back";
        std::printf("%s: %lu calls, %lu bytes\n", kCullings[static_cast<size_t>(culling)],
                    static_cast<unsigned long>(glCalls.calls), static_cast<unsigned long>(glCalls.bytes));
    }
}

TEST(GpuCells, EveryGlFunctionOfTheEngineIsCounted) {
    const std::set<std::string> counted(std::begin(kCountedGlCalls), std::end(kCountedGlCalls));
    const std::regex call(R"(\bgl[A-Z]\w*(?=\())");
    for (const auto& file :
         std::filesystem::recursive_directory_iterator(std::filesystem::path(SWARD_SOURCE_DIR) / "engine")) {
        if (!file.is_regular_file()) continue;
        const std::string text = readText(file.path());
        for (std::sregex_iterator it(text.begin(), text.end(), call), end; it != end; ++it)
            if (it->str() != "glTF") EXPECT_TRUE(counted.contains(it->str())) << it->str() << " in " << file.path();
    }
}

}  // namespace
}  // namespace sward::test
