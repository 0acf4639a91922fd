// Whether any pixel of the sample projects is brighter than their lights can make it, from 2,000 random places at one,
// four and eight samples a pixel (as many as the driver has), blended and covered by samples.
#include "bench/limits.h"
#include "project/project_files.h"
#include "techniques.h"
#include "tests/grass/bright_pixels.h"

namespace {
using namespace sward;
using namespace sward::test;

constexpr const char* kProjects[] = {"football", "park",  "meadow",  "wheat",  "tornado",
                                     "lawn",     "oasis", "rockery", "prairie"};
constexpr int kFrames = 2000 / (9 * 6) + 1;  // of each project, way and number of samples

void measure() {
    BrightPixels found;
    uint32_t place = 0;
    for (const char* name : kProjects) {
        auto project = loadProject(std::string(SWARD_SOURCE_DIR "/projects/") + name, tables().components);
        if (!project || !gpu()) return reportLimit("projects that open", 0, -1, "");
        removeEntity(*project, "antialias");  // frames that add up have one sample each
        Renderer r(*gpu(), tables());
        for (const Transparency way : {Transparency::Coverage, Transparency::Blend})
            for (const int msaa : {1, 4, 8}) {
                setTransparency(*project, way);
                for (int i = 0; i < kFrames; ++i, ++place)
                    lookFrom(r, *project, placeToLook(*project, 0.37 * place, place), 0.37 * place, msaa, 4, found);
            }
    }
    std::fprintf(stderr, "%d frames, the brightest pixel %.3g times what the lights give\n", found.frames, found.worst);
    reportLimit("pixels over 4 times what the lights give, of 2,000 frames", found.frames < 1900 ? NAN : found.pixels,
                0, "pixels");
}
SWARD_LIMITS("bright pixels", measure);

}  // namespace
