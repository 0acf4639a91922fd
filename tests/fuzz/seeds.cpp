// Writes the seeds of the fuzz targets, small sound files of each kind: seeds FOLDER makes FOLDER/NAME/ for each
// target.
#include <cstdio>

#include "core/file.h"
#include "core/json.h"
#include "cost/cost_files.h"
#include "grass/slice_file.h"
#include "maps/image_file.h"
#include "maps/map_io.h"
#include "maps/tile_file.h"
#include "mesh/mesh_io.h"
#include "mesh/mesh_shapes.h"
#include "project/project_files.h"
#include "project/project_json.h"
#include "reference/reference_part.h"
#include "techniques.h"
#include "tests/support.h"

using namespace sward;
namespace fs = std::filesystem;

namespace {

void seed(const fs::path& folder, const std::string& target, const std::string& name, const std::string& bytes) {
    test::writeText(folder / target / name, bytes);
}

// A project with one of each component.
Project everything() {
    Project p;
    p.name = "seed";
    for (const ComponentRow& row : tables().components) row.assign(p.registry, *addEntity(p, row.name), nullptr);
    return p;
}

void seedProjects(const fs::path& to) {
    const std::string text = writeJson(projectJson(everything(), tables().components));
    seed(to, "project", "everything", text);
    seed(to, "project", "empty", "{}");
    seed(to, "recovery", "everything",
         text + "\n----\nmaps/a.png\n\n----\n{\"at\": 1, \"before\": 1885433120, \"after\": 7, \"size\": 5}");
    seed(to, "recovery", "outside", "{}\n----\n../outside.png\n/etc/passwd\n");
}

// The same as a file of tiles.
void seedTiles(const fs::path& to, const std::string& name, const Map& map) {
    const test::TempDir dir;
    if (!writeTiles(dir / "tiles.tif", map)) return;
    const std::string bytes = test::readText(dir / "tiles.tif");
    seed(to, "image", "tiles-" + name, bytes);
    seed(to, "image_head", "tiles-" + name, bytes);
}

void seedImages(const fs::path& to) {
    for (const char* format : {"png", "exr", "tif"})
        for (const PixelType type : {PixelType::U8, PixelType::U16, PixelType::F32})
            for (const int channels : {1, 3}) {
                if ((type == PixelType::F32 && format[0] == 'p') || (type != PixelType::F32 && format[0] == 'e'))
                    continue;
                const MapInfo info{5, 4, channels, type};
                Map map(info);
                for (int i = 0; i < 20; ++i) map.set(i % 5, i / 5, 0, static_cast<float>(i) / 20);
                const auto bytes =
                    encodeImage(format, info, [&](int y, int rows, void* out) { map.readRows(y, rows, out); });
                if (!bytes) continue;
                const std::string name =
                    std::string(format) + std::to_string(static_cast<int>(type)) + std::to_string(channels);
                seed(to, "image", name, *bytes);
                seed(to, "image_head", name, *bytes);
                if (format[0] == 't' && type != PixelType::F32) seedTiles(to, name, map);
            }
}

void seedSlices(const fs::path& to) {
    SliceImages images{1, 0.3f, 0.7f, {}, {}};
    const auto level = [](int side, size_t layers) {
        const std::vector<uint8_t> texels(4 * layers * size_t(side) * size_t(side), 77);
        return SliceLevel{side, side, texels, texels, texels, texels};
    };
    for (const int side : {2, 1}) images.vertical.push_back(level(side, 2)), images.far.push_back(level(side, 1));
    const test::TempDir dir;
    constexpr uint64_t kKey = 0x123456789abcdef0;
    cacheSlices(dir.path, kKey, images);
    const std::string bytes = test::readText(sliceFile(dir.path, kKey));
    seed(to, "slices", "two", bytes.substr(0, bytes.size() - 8));
}

void seedResults(const fs::path& to) {
    seed(to, "part", "cost", writeJson(costJson(CostRun{})));
    ReferencePart part;
    part.settings.width = 2, part.settings.height = 2;
    part.truth = {2, 2, std::vector<float>(12, 0.5f), std::vector<float>(12, 0.1f), std::vector<float>(4, 1)};
    seed(to, "part", "part", encodePart(part));
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) return std::fprintf(stderr, "seeds FOLDER\n"), 2;
    const fs::path to = argv[1];
    seedProjects(to);
    seedImages(to);
    seedSlices(to);
    seedResults(to);
    const Solid solids[] = {{.kind = SolidKind::Box, .unwrap = true}, {.kind = SolidKind::Leaves, .count = 2}};
    if (const auto bytes = encodeGlb(makeMesh(solids))) seed(to, "mesh", "solids", *bytes);
    seed(
        to, "mesh", "text",
        R"({"asset":{"version":"2.0"},"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"nodes":[{"mesh":0}],)"
        R"("scenes":[{"nodes":[0]}],"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],)"
        R"("bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":36,"uri":"data:application/octet-stream;)"
        R"(base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})");
    seed(to, "script", "calls", std::string("\0\1\2\4\5\6\7\1\2\3\4\5\6\7\10\11\12\13\14", 19));
    return 0;
}
