#include "model/portrait.h"

#include <algorithm>
#include <cmath>

#include "core/file.h"
#include "core/hash.h"
#include "core/numerics.h"
#include "maps/image_file.h"
#include "maps/map_io.h"
#include "mesh/mesh_io.h"
#include "project/project_files.h"
#include "reference/reference.h"

namespace fs = std::filesystem;

namespace sward {
namespace {

constexpr int kSamples = 16;
constexpr double kGround = 60;         // metres of the plain ground on which things stand
constexpr const char* kVersion = "1";  // of how portraits are taken: another one takes them anew

template <class C>
void add(Project& p, const char* entity, C component) {
    p.registry.add<C>(*addEntity(p, entity), std::move(component));
}

// Plain ground under a clear day, with the sun behind the one who looks.
Project studio(const glm::vec3& groundColor) {
    Project p;
    Terrain ground;
    ground.size = {kGround, kGround};
    ground.groundColor = groundColor;
    add(p, "ground", std::move(ground));
    add(p, "sky", Sky{});
    Light sun;
    sun.azimuthDeg = 195;
    sun.elevationDeg = 48;
    add(p, "sun", sun);
    return p;
}

// From the south-east, looking down; so far off that a ball of this radius fills the picture.
ViewCamera cameraOn(const glm::dvec3& middle, double radius, double downDeg) {
    ViewCamera c;
    c.fovDeg = 30;
    c.target = middle;
    const double down = glm::radians(downDeg), far = radius / std::sin(glm::radians(15.0));
    c.eye = middle + far * glm::dvec3(0.6 * std::cos(down), std::sin(down), 0.8 * std::cos(down));
    return c;
}

Rgba8 shownOf(const Truth& t) {
    Rgba8 out{t.width, t.height,
              std::vector<uint8_t>(static_cast<size_t>(t.width) * static_cast<size_t>(t.height) * 4, 255)};
    for (size_t i = 0; i < out.pixels.size() / 4; ++i) {
        const glm::vec3 light(t.color[i * 3], t.color[i * 3 + 1], t.color[i * 3 + 2]);
        const glm::vec3 c = f32::srgbEncode3(f32::toneMapNeutral(glm::max(light, glm::vec3(0))));
        for (int k = 0; k < 3; ++k)
            out.pixels[i * 4 + static_cast<size_t>(k)] =
                static_cast<uint8_t>(std::lround(glm::clamp(c[k], 0.f, 1.f) * 255));
    }
    return out;
}

Result<Rgba8> traced(const Project& p, const ViewCamera& camera, const Tables& tables, JobControl& control) {
    const Result<ReferenceScene> scene = ReferenceScene::make(p, tables, 0, control);
    if (!scene) return scene.error();
    ReferenceSettings s;
    s.width = s.height = kPortraitSide;
    s.samples = kSamples;
    const Result<Truth> truth = scene->trace(camera, s, control);
    return truth ? Result<Rgba8>(shownOf(*truth)) : truth.error();
}

// The picture under this hash in the cache folder, else what `make` gives, which is put there; a folder that cannot be
// written costs no more than the time.
template <class F>
Result<Rgba8> kept(uint64_t hash, const F& make) {
    const fs::path file = cacheDir() / "portraits" / (hashHex(hash) + ".png");
    std::error_code fault;
    if (fs::exists(file, fault))
        if (Rgba8 image = loadColorImage(file); image.width == kPortraitSide && image.height == kPortraitSide)
            return image;
    Result<Rgba8> made = make();
    if (made && makeFolderOf(file)) (void)writeImagePng(file, made->width, made->height, 4, made->pixels);
    return made;
}

template <class T>
void addAll(Hasher& h, const std::vector<T>& items) {
    h.add(items.data(), items.size() * sizeof(T));
}

uint64_t hashOf(const Mesh& mesh) {
    Hasher h;
    h.add(kVersion, 1);
    addAll(h, mesh.vertices);
    addAll(h, mesh.indices);
    for (const MeshPart& p : mesh.parts) {
        h.add(&p.count, sizeof p.count);
        h.add(&p.color, sizeof p.color);
        h.add(&p.image, sizeof p.image);
        h.add(&p.cutoff, sizeof p.cutoff);
    }
    for (const MeshImage& i : mesh.images) addAll(h, i.rgba);
    return h.value();
}

// Where a texel of the small picture begins in the large one.
int begin(int i, int from, int to) { return static_cast<int>(static_cast<int64_t>(i) * from / to); }

Rgba8 emptyFor(int width, int height) {
    const double by = std::min(1.0, static_cast<double>(kPortraitSide) / std::max(width, height));
    Rgba8 out{std::max(1, static_cast<int>(std::lround(width * by))),
              std::max(1, static_cast<int>(std::lround(height * by))),
              {}};
    out.pixels.resize(static_cast<size_t>(out.width) * static_cast<size_t>(out.height) * 4);
    return out;
}

// Mean values of the large picture's texels in each of the small one's, four channels; rows come one after the other.
struct Shrunk {
    Shrunk(const MapInfo& from, const Rgba8& to)
        : info(from), width(to.width), height(to.height), sums(to.pixels.size()), counts(to.pixels.size() / 4) {}
    void addRow(int y, const Map& row) {
        const int at = std::min(height - 1, static_cast<int>(static_cast<int64_t>(y) * height / info.height));
        for (int x = 0; x < width; ++x)
            for (int from = begin(x, info.width, width);
                 from < std::max(begin(x + 1, info.width, width), begin(x, info.width, width) + 1); ++from) {
                const size_t i = static_cast<size_t>(at) * static_cast<size_t>(width) + static_cast<size_t>(x);
                ++counts[i];
                for (int c = 0; c < info.channels; ++c)
                    if (const float v = row.at(from, 0, c); std::isfinite(v))
                        sums[i * 4 + static_cast<size_t>(c)] += static_cast<double>(v);
            }
    }
    double mean(size_t i, int channel) const {
        return sums[i * 4 + static_cast<size_t>(channel)] / std::max(1, counts[i]);
    }
    MapInfo info;
    int width, height;
    std::vector<double> sums;
    std::vector<int> counts;
};

// The range that is shown from black to white: floats by what they hold, shares of a full scale as they are.
std::pair<double, double> shownRange(const Shrunk& s, bool stretched) {
    if (!stretched) return {0, 1};
    double low = s.mean(0, 0), high = low;
    for (size_t i = 0; i < s.counts.size(); ++i)
        for (int c = 0; c < std::min(3, s.info.channels); ++c)
            low = std::min(low, s.mean(i, c)), high = std::max(high, s.mean(i, c));
    return {low, high > low ? high : low + 1};
}

uint8_t byteOf(double v) { return static_cast<uint8_t>(std::lround(std::clamp(v, 0.0, 1.0) * 255)); }

void fill(Rgba8& out, const Shrunk& s, bool stretched) {
    const auto [low, high] = shownRange(s, stretched);
    const int channels = s.info.channels;
    for (size_t i = 0; i < s.counts.size(); ++i) {
        for (int c = 0; c < 3; ++c) {
            const double v = channels == 1 ? s.mean(i, 0) : c < channels ? s.mean(i, c) : 0.5;
            out.pixels[i * 4 + static_cast<size_t>(c)] = byteOf((v - low) / (high - low));
        }
        out.pixels[i * 4 + 3] = channels == 4 ? byteOf(s.mean(i, 3)) : 255;
    }
}

uint64_t hashOf(const Species& s, const fs::path& root, const Tables& tables) {
    Project p = studio(glm::vec3(0));
    p.name = kVersion;
    p.dir = root;
    GrassField field;
    field.species = {s};
    field.species[0].density = {};
    add(p, "grass", std::move(field));
    return projectHash(p, tables.components);
}

}  // namespace

Result<Rgba8> portraitOfModel(const fs::path& root, const std::string& file, const Tables& tables,
                              JobControl& control) {
    const Result<Mesh> mesh = readMesh(root, file);
    if (!mesh) return mesh.error();
    return kept(hashOf(*mesh), [&] {
        const glm::dvec3 low(mesh->low), high(mesh->high), middle = (low + high) * 0.5;
        const double radius = std::max(1e-6, glm::length(high - low) / 2);
        Project p = studio(glm::vec3(0.16f));
        p.dir = root;
        StaticMesh object;
        object.file = file;
        object.onGround = false;
        object.scale = static_cast<float>(std::clamp(1 / radius, 0.001, 1000.0));
        const double scale = static_cast<double>(object.scale);
        add(p, "object", std::move(object));
        const glm::dvec3 at{kGround / 2 - middle.x * scale, -low.y * scale, kGround / 2 - middle.z * scale};
        p.registry.add<Transform>(findEntity(p, "object"), {at});
        return traced(p, cameraOn(at + middle * scale, radius * scale * 0.95, 26), tables, control);
    });
}

Result<Rgba8> portraitOfSpecies(const Species& species, const fs::path& root, const Tables& tables,
                                JobControl& control) {
    Species bare = species;
    bare.density = {};
    return kept(hashOf(bare, root, tables), [&] {
        const double tall = std::max(0.02, static_cast<double>(bare.height)), side = std::max(0.6, 5 * tall);
        Project p = studio(Terrain{}.groundColor);
        p.dir = root;
        p.registry.get<Terrain>(findEntity(p, "ground"))->size = {side, side};
        GrassField field;
        field.cellSize = static_cast<float>(std::clamp(side / 2, 0.5, 4.0));
        field.species = {bare};
        add(p, "grass", std::move(field));
        return traced(p, cameraOn({side / 2, tall * 0.45, side / 2}, side * 0.33, 24), tables, control);
    });
}

uint64_t portraitKey(const Species& species, const Tables& tables) { return hashOf(species, {}, tables); }

Result<Rgba8> portraitOfImage(const fs::path& file, const JobControl& control) {
    const Result<std::unique_ptr<ImageReader>> reader = ImageReader::open(file);
    if (!reader) return reader.error();
    const MapInfo info = (*reader)->info();
    Rgba8 out = emptyFor(info.width, info.height);
    Shrunk shrunk(info, out);
    const MapInfo line{info.width, 1, info.channels, info.type};
    Map row(line);
    std::vector<std::byte> bytes(static_cast<size_t>(info.width) * row.texelBytes());
    for (int y = 0; y < info.height; ++y) {
        if (control.cancelled()) return failed("cancelled");
        if (Status read = (*reader)->readRows(y, 1, bytes.data()); !read) return read.error();
        row.writeRows(0, 1, bytes.data());
        shrunk.addRow(y, row);
    }
    fill(out, shrunk, info.type == PixelType::F32);
    return out;
}

Rgba8 portraitOfMap(const Map& map, MapKind kind) {
    constexpr int kAcross = 3;  // samples of each texel of the small picture, each way
    Rgba8 out = emptyFor(map.info().width, map.info().height);
    MapInfo seen = map.info();
    seen.width = std::min(seen.width, out.width * kAcross), seen.height = std::min(seen.height, out.height * kAcross);
    Shrunk shrunk(seen, out);
    Map row({seen.width, 1, seen.channels, PixelType::F32});
    for (int y = 0; y < seen.height; ++y) {
        for (int x = 0; x < seen.width; ++x)
            for (int c = 0; c < seen.channels; ++c)
                row.set(x, 0, c,
                        map.at(begin(x, map.info().width, seen.width), begin(y, map.info().height, seen.height), c));
        shrunk.addRow(y, row);
    }
    fill(out, shrunk, kind == MapKind::Heights);
    if (kind == MapKind::Forces)
        for (size_t i = 3; i < out.pixels.size(); i += 4) out.pixels[i] = 255;
    return out;
}

}  // namespace sward
