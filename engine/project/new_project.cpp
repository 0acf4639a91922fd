#include "core/utf8.h"
#include "project/project_files.h"

namespace fs = std::filesystem;

namespace sward {
namespace {

// A lawn of 40 x 40 m to begin with. Its density map is there, all ones, so that it can be painted at once.
Project emptyProject(const fs::path& dir) {
    Project p;
    p.dir = dir;
    p.name = utf8Text(dir.has_filename() ? dir.filename().string() : dir.parent_path().filename().string());
    Map density({256, 256, 1, PixelType::U16});
    const std::vector<uint16_t> row(256, 65535);
    for (int y = 0; y < 256; ++y) density.writeRows(y, 1, row.data());
    GrassField field;
    Species& lawn = field.species[0];
    lawn.name = "lawn";
    lawn.bladesPerM2 = 4000;  // with broad blades that lie over the ground: green from above, at a third of a real lawn
    lawn.width = 0.006f, lawn.bend = 0.7f, lawn.leanDeg = 14;
    lawn.density = {"maps/lawn.lawn.density.png", std::move(density)};
    Terrain ground;
    ground.beyond = LandBeyond::Fade;
    ground.groundColor = {0.06f, 0.07f, 0.03f};  // mossy: what shows between blades is no bare soil
    p.registry.add<Terrain>(*addEntity(p, "ground"), std::move(ground));
    p.registry.add<GrassField>(*addEntity(p, "lawn"), std::move(field));
    p.registry.add<Light>(*addEntity(p, "sun"));
    p.registry.add<Sky>(*addEntity(p, "sky"), {.model = SkyModel::Atmosphere, .turbidity = 1.5f});
    p.registry.add<Fog>(*addEntity(p, "haze"), {.visibility = 25000});
    p.registry.add<Camera>(*addEntity(p, "camera"));
    return p;
}

}  // namespace

Result<Project> newProject(const fs::path& dir, std::span<const ComponentRow> rows) {
    std::error_code fault;
    if (fs::exists(dir, fault) && (!fs::is_directory(dir, fault) || !fs::is_empty(dir, fault)))
        return failed("exists and is not an empty folder", "name a new or an empty folder").at(dir);
    Project p = emptyProject(dir);
    SaveWay way;
    way.stamps = &p.stamps;
    const auto saved = saveProject(p, rows, nullptr, way);
    return saved ? Result<Project>(std::move(p)) : saved.error();
}

}  // namespace sward
