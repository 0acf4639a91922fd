// What a frame costs beside its drawing: culling and lists, and sending a stamp to the GPU.
#include "bench/limits.h"
#include "brushes/brush.h"
#include "frame/map_textures.h"
#include "frame/renderer.h"
#include "project/project_files.h"
#include "techniques.h"
#include "world/view_camera.h"

namespace {
using namespace sward;

// Median over repeated frames of the CPU's part: quadtree, density ranges, commands.
double cullMs(Project& project, const std::string& camera) {
    Renderer renderer(*gpu(), tables());
    ViewSettings s;
    s.width = 320, s.height = 240;
    std::vector<double> ms;
    for (int i = 0; i < 7; ++i) {
        if (!renderer.draw(project, viewOf(*findCamera(project, camera)), s)) return NAN;
        renderer.finish();
        if (i > 1) ms.push_back(renderer.stats().cpuCullMs);
    }
    return median(ms);
}

SWARD_LIMITS("cull", [] {
    auto project = loadProject(std::string(SWARD_SOURCE_DIR) + "/projects/football", tables().components);
    const bool ready = project && gpu();
    reportLimit("culling and lists, football at whole", ready ? cullMs(*project, "whole") : NAN, 1, "ms");
    reportLimit("culling and lists, football at human", ready ? cullMs(*project, "human") : NAN, 1, "ms");
});

// A stamp of 500 texels' radius on 4096 x 4096: the tiles, their undo, and their upload with mip levels, to the finish.
SWARD_LIMITS("brush", [] {
    Map map({4096, 4096, 1, PixelType::U16});
    const BrushRow& row = *findBrush("add");
    BrushSettings brush;
    brush.strength = 0.1f;
    std::vector<double> ms;
    if (gpu()) {
        MapTextures textures(*gpu());
        textures.beginFrame();
        textures.get("bench", "map", map);
        glFinish();
        for (int i = 0; i < 15; ++i) {
            const Map undo = map;
            ms.push_back(1000 * seconds([&] {
                             applyStamp(map, row, {2000.0 + i, 2100, 500, 500}, brush);
                             textures.get("bench", "map", map);
                             glFinish();
                         }));
        }
    }
    reportLimit("stamp of 500 texels' radius, undo and upload included", median(ms), 8, "ms");
});

}  // namespace
