// A scene that asks for almost every feature at once.
#pragma once
#include "fields.h"
#include "grass/mesh_grass_settings.h"
#include "objects.h"
#include "scene/forest.h"
#include "scene/scatter.h"

namespace sward::test {

// Where its object lies, for as long as the process lives.
inline const std::filesystem::path& objectsFolder() {
    static const TempDir dir;
    return dir.path;
}
// A lawn with water, flowers, objects, forces, lamps and maps: almost every feature at once.
inline Project everything() {
    Project p = lawn();
    FlatField f = flatField(p, "grass");
    Terrain& t = *p.registry.get<Terrain>(findEntity(p, "ground"));
    f.species[0].density = field(filled({64, 64, 1, PixelType::U16}, 0.7f));
    f.orientation = field(filled({16, 16, 2, PixelType::U16}, 0.8f));
    f.vegetation = field(filled({16, 16, 4, PixelType::U8}, 0.4f));
    f.ambientOcclusion = field(filled({16, 16, 1, PixelType::U8}, 0.9f));
    f.forces = field(filled({16, 16, 4, PixelType::U8}, 0.6f));
    f.farBlur = FarBlur::Gaussian;
    f.farDarkening = 0.3f;
    put<Wind>(p, "wind");
    put<ForceSource>(p, "stone");
    put(p, "stone", Transform{{10, 0, 8}});
    t.height = field(filled({32, 32, 1, PixelType::F32}, 0.5f));
    t.terrainMap = field(filled({32, 32, 4, PixelType::U8}, 0.3f));
    t.castShadows = true;
    p.dir = objectsFolder();
    putObject(p, "cube", {{.unwrap = true}}, {6, 0, 6});
    put(p, "cube",
        MeshGrass{.density = field(filled({16, 16, 1, PixelType::U8}, 0.9f)),
                  .vegetation = field(filled({16, 16, 4, PixelType::U8}, 0.5f)),
                  .orientation = field(filled({16, 16, 2, PixelType::U16}, 0.7f))});
    put<ForceSource>(p, "cube").shape = ForceShape::Outline;
    f.species[0].translucency = 0.5f;
    f.species[0].gloss = 1;
    f.sliceWidth = f.sliceHeight = f.farSize = 32;
    put<Water>(p, "lake", {.level = 0.56f});  // ground lies at 0.5
    put<Scatter>(p, "stones", {.meshes = {{"cube", "cube.glb"}}, .perHectare = 500});
    put<Forest>(
        p, "trees",
        {.species = {{.leaves = 40}}, .perHectare = 900, .distance = 2, .tileSize = 8, .meshesTo = 14, .voxel = 1});
    put<Flowers>(p, "flowers",
                 {.density = field(filled({16, 16, 1, PixelType::U16}, 0.5f)), .flowersPerM2 = 10, .headSize = 0.1f});
    Light lamp;
    lamp.type = LightType::Point;
    put(p, "lamp", lamp);
    put(p, "lamp", Transform{{6, 1, 6}});
    return p;
}

}  // namespace sward::test
