// Shadows of the horizontal slice on the soil, against those that blades throw one by one.
#include "grass/far_shadow.h"

#include "fields.h"
#include "pixels.h"
#include "scenes.h"
#include "support.h"
#include "techniques.h"
#include "world/view_camera.h"

namespace sward::test {
namespace {

// How red a lawn on red soil is, and how unlike its pixels are.
struct SoilSeen {
    double mean, variance;
};
// Grass is so sparse that much of the soil is seen. shadows: piece by piece, else in the mean alone.
SoilSeen soilUnder(Renderer& r, Technique technique, bool shadows) {
    Project p = lawn();
    FlatField f = flatField(p);
    f.technique = nameOf(technique), f.groundShadows = shadows;
    f.species[0].bladesPerM2 = 300;
    f.sliceWidth = f.farSize = 64, f.sliceHeight = 32;
    p.registry.get<Terrain>(findEntity(p, "ground"))->groundColor = {0.2f, 0.05f, 0.05f};
    ViewSettings view;
    view.width = 160, view.height = 120, view.msaa = 4;
    const Status drawn = r.draw(p, {{10, 2.5, 1}, {10, 0, 4}, 40, 0}, view);
    EXPECT_TRUE(drawn) << (drawn ? "" : drawn.error().text());
    const std::vector<float> seen = r.readLinear();
    double sum = 0, squares = 0;
    for (size_t i = 0; i < seen.size(); i += 3) sum += seen[i], squares += seen[i] * seen[i];
    const double n = static_cast<double>(seen.size()) / 3;
    return {sum / n, squares / n - sum / n * sum / n};
}

TEST(FarShadow, ShadesTheSoilBladeByBladeUnderRaysAndTessellatedBlades) {
    NoGlErrors errors;
    Renderer r(gpu(), tables());
    const SoilSeen blades = soilUnder(r, Technique::Geometry, true),
                   unshaded = soilUnder(r, Technique::Geometry, false);
    for (const Technique technique : {Technique::Raytraced, Technique::Tessellated}) {
        const SoilSeen slice = soilUnder(r, technique, true), mean = soilUnder(r, technique, false);
        std::printf("%s: shadows add %.6f to red's variance (blades' %.6f); with them %.4f of the light (%.4f)\n",
                    nameOf(technique), slice.variance - mean.variance, blades.variance - unshaded.variance,
                    slice.mean / mean.mean, blades.mean / unshaded.mean);
        EXPECT_GT(slice.variance - mean.variance, 0.3 * (blades.variance - unshaded.variance));
        EXPECT_NEAR(slice.mean / mean.mean, blades.mean / unshaded.mean, 0.06) << "in the mean as much";
    }
}

}  // namespace
}  // namespace sward::test
