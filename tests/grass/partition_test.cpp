// Who draws each blade of a field, by the shaders' own formulas: B-12, B-13.
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "core/numerics.h"
#include "fields.h"
#include "grass/cells.h"

namespace sward {
namespace {

using namespace test;

constexpr float kDensities[] = {0.0f, 0.1f, 0.25f, 0.5f, 0.6f, 0.9f, 1.0f};
constexpr double kSide = 12;
const glm::dvec3 kEye{6, 1.7, 6};

Frustum unbounded() {
    Frustum f;
    f.planes.fill(glm::vec4(0, 0, 0, 1));
    return f;
}

struct Counts {
    uint64_t exist = 0, geometry = 0, slices = 0, wrong = 0;  // wrong: none or both, or one where none may be
};

FlatField halfWay() {
    FlatField f;
    f.species[0].bladesPerM2 = 800;
    f.minGeom = 2, f.maxGeom = 7, f.minBTF = 20, f.maxBTF = 30;
    f.fade = 0;
    return f;
}

// The cells that each tier is given, and of each cell the blades that geometry is given.
struct Chosen {
    std::map<std::pair<int, int>, CellDraw> blades;
    std::set<std::pair<int, int>> slices;
};
Chosen choose(const FlatField& f, const Patch& patch, const Map& density) {
    Terrain ground;
    ground.size = {kSide, kSide};
    f.species[0].density = {"maps/d.png", density};
    const Frustum all = unbounded();
    const HeightBounds flat;
    const CellQuery q = cellQuery(queryOf(ground, flat, f, patch), {kEye, all, 200});
    Chosen c;
    for (const CellDraw& d : selectCells(q)) c.blades[{d.cellX, d.cellZ}] = d;
    for (const SliceCell& s : selectSliceCells(q, f.minGeom, f.maxBTF)) c.slices.insert({s.cellX, s.cellZ});
    return c;
}

// Distance of a blade of a cell from the eye, where the cell's version has it.
float distanceOf(const Blade& b, int x, int z, const FlatField& f) {
    const f32::CellVersion v = f32::cellVersion(x, z, static_cast<uint32_t>(f.seed));
    const glm::vec2 in = f32::rootInCell(b.root, v.mirror, v.shift, f.cellSize);
    return static_cast<float>(glm::length(glm::dvec3(x * f.cellSize + in.x, 0, z * f.cellSize + in.y) - kEye));
}

Map constant(float value) {
    Map m({2, 2, 1, PixelType::F32});
    for (int i = 0; i < 4; ++i) m.set(i % 2, i / 2, 0, value);
    return m;
}

// published: geometry by the paper's rule instead.
Counts countField(float density, bool published) {
    const FlatField f = halfWay();
    const Patch patch = makePatch(f.species[0], f.cellSize, static_cast<uint32_t>(f.seed));
    const Chosen chosen = choose(f, patch, constant(density));
    const float inv = f32::lodInverse(f.minGeom, f.maxGeom);
    Counts n;
    for (int x = 0; x < static_cast<int>(kSide / f.cellSize); ++x)
        for (int z = 0; z < static_cast<int>(kSide / f.cellSize); ++z) {
            const auto draw = chosen.blades.find({x, z});
            const bool sliced = chosen.slices.contains({x, z});
            for (uint32_t i = 0; i < patch.blades.size(); ++i) {
                const Blade& b = patch.blades[i];
                const float weight = f32::lodRamp(distanceOf(b, x, z, f), f.minGeom, inv);
                const bool submitted = draw != chosen.blades.end() && i >= draw->second.first && i < draw->second.last;
                const bool geometry = published
                                          ? f32::geometryHoldsPublished(density, 1 - weight, b.threshold)
                                          : submitted && f32::geometryOpacity(density, weight, b.threshold, 0) > 0;
                const bool slices = sliced && f32::sliceOpacity(density, weight, b.threshold, 0) > 0;
                const bool exists = b.threshold <= density;
                n.exist += exists, n.geometry += geometry, n.slices += slices;
                n.wrong += geometry + slices != (exists ? 1 : 0);
            }
        }
    return n;
}

TEST(Partition, OfConstantDensityEachBladeIsInGeometryOrInSlices) {
    for (const float density : kDensities) {
        const Counts n = countField(density, false);
        EXPECT_EQ(n.wrong, 0u) << density;
        EXPECT_EQ(n.geometry + n.slices, n.exist) << density;
        if (density >= 0.1f) EXPECT_GT(std::min(n.geometry, n.slices), n.exist / 20) << "both tiers are tried";
    }
}

TEST(Partition, ThePublishedRuleExchangesTheField) {
    const Counts n = countField(0.5f, true);
    EXPECT_GT(n.wrong, n.exist / 10);
}

TEST(Partition, FadingOpacitiesSumToEquationFive) {
    const Patch patch = makePatch(halfWay().species[0], 0.5f, 1);
    for (const float omega : {0.05f, 0.2f, 0.4f})
        for (const float density : kDensities)
            for (int w = 0; w <= 16; ++w)
                for (const Blade& b : patch.blades) {
                    const float weight = static_cast<float>(w) / 16;
                    const float sum = f32::geometryOpacity(density, weight, b.threshold, omega) +
                                      f32::sliceOpacity(density, weight, b.threshold, omega);
                    ASSERT_NEAR(sum, f32::opacityConserving(density, b.threshold, omega), 1.2e-7f);
                    if (omega <= density && density <= 1 - omega)
                        ASSERT_NEAR(sum, f32::opacityPublished(density, b.threshold, omega), 1e-6f);
                }
}

TEST(Partition, ThresholdsAreTheSameAsTheTexelsOfSlicesHoldThem) {
    for (int k = 1; k <= 255; ++k) EXPECT_EQ(std::round(f32::thresholdOf(k) * 255.0f) / 255.0f, f32::thresholdOf(k));
    for (const Blade& b : makePatch(halfWay().species[0], 0.5f, 1).blades)
        ASSERT_EQ(f32::thresholdOf(static_cast<int>(std::lround(b.threshold * 255))), b.threshold);
}

}  // namespace
}  // namespace sward
