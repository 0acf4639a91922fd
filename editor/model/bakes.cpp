#include "model/bakes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <chrono>
#include <filesystem>
#include <thread>

#include "core/file.h"
#include "core/hash.h"
#include "core/log.h"
#include "grass/slices.h"
#include "maps/map_io.h"
#include "reference/occlusion.h"
#include "scene/tiling.h"
#include "script/script.h"
#include "world/ground.h"

namespace sward {
namespace {

OcclusionSettings settingsOf(const BakeSettings& s) { return {s.samples, s.size}; }

// Of the first field by name; empty if there is none.
std::string fieldEntity(const Project& p) {
    for (const auto& [name, e] : p.entities)
        if (p.registry.get<GrassField>(e)) return name;
    return "";
}

// From the cache, or made and put there; a cache that cannot be written to is no fault.
Result<Map> occlusionOf(const Project& p, const OcclusionSettings& settings, uint64_t hash, JobControl& control) {
    const std::filesystem::path file = cacheDir() / "occlusion" / (hashHex(hash) + ".png");
    std::error_code ignored;
    if (std::filesystem::exists(file, ignored))
        if (Result<Map> kept = readMap(file, MapWish{})) return kept;
    Result<Map> made = bakeOcclusion(p, settings, control);
    if (!made) return made;
    std::filesystem::create_directories(file.parent_path(), ignored);
    if (Status s = writeMap(file, *made); !s) logInfo("not cached: " + s.error().text());
    return made;
}

Status useOcclusion(Document& document, Map map) {
    const std::string field = fieldEntity(document.project()) + ".GrassField.ambientOcclusion";
    document.beginGroup("bake ambient occlusion");
    const Terrain& t = *findGround(document.project()).terrain;
    Status done = document.setField(field + "Tiling",
                                    fmt::format("{}", mapExtent(t).x / t.size.x));  // the map is made for its place
    if (done) done = document.setMap(field, std::move(map), "bake ambient occlusion");
    done ? document.endGroup() : document.cancelGroup();
    return done;
}

// Until the job has ended; cancels it when told to.
template <class T>
void await(Job<T>& job, const BakeProgress& progress) {
    while (!job.finished()) {
        if (!progress(job.progress())) job.cancel();
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
}

Result<std::string> runOcclusion(Document& document, const BakeSettings& settings, const BakeProgress& progress) {
    Result<OcclusionBake> bake = startOcclusion(document, settings);
    if (!bake) return bake.error();
    await(bake->job, progress);
    const auto end = finishOcclusion(document, *bake);
    if (!*end) return end->error();
    progress(1);
    return std::string("made for the project's first field");
}

Result<std::string> keepSlices(const SliceSpec& spec, const BakeProgress& progress) {
    const auto cached = std::make_shared<bool>(false);
    Job<SliceImages> job("slices of " + spec.species.name, 0, [spec, cached](JobControl& control) {
        return slicesOf(cacheDir(), spec, control, cached.get());
    });
    await(job, progress);
    const std::optional<Result<SliceImages>> made = job.take(0);
    if (!made)
        return interruption("slices of " + spec.species.name + " were not baked: it was cancelled", "bake again");
    if (!*made) return made->error();
    return fmt::format("{}: {:.1f} MB{}", spec.species.name, static_cast<double>((*made)->bytes()) / 1e6,
                       *cached ? ", cached already" : "");
}

Result<std::string> runSlices(Document& document, const BakeSettings&, const BakeProgress& progress) {
    if (!document.isOpen()) return failed("no project is open", "open or create one first");
    const std::vector<SliceSpec> specs = projectSlices(document.project(), document.tables());
    std::vector<std::string> said;
    for (const SliceSpec& spec : specs) {
        const Result<std::string> kept = keepSlices(spec, [&](double share) {
            return progress((static_cast<double>(said.size()) + share) / static_cast<double>(specs.size()));
        });
        if (!kept) return kept.error();
        said.push_back(*kept);
    }
    progress(1);
    return said.empty() ? std::string("nothing is drawn as slices") : fmt::format("{}", fmt::join(said, "; "));
}

constexpr BakeRow kRows[] = {
    {"slices", "slices", "images of blades for grass that is drawn as slices, into the cache", runSlices},
    {"ambientOcclusion", "ao",
     "which share of the sky objects and hills leave the ground to see, into GrassField.ambientOcclusion",
     runOcclusion},
};

}  // namespace

std::span<const BakeRow> bakeRows() { return kRows; }

void offerBakes(ScriptHost& host) {
    for (const BakeRow& row : bakeRows())
        host.bakes[row.name] = [&host, &row](int samples, int size) {
            const Result<std::string> made = row.run(host.document, {samples, size}, [](double) { return true; });
            return made ? Status{} : Status{made.error()};
        };
}

Status checkBakeSettings(const BakeSettings& s) {
    if (s.samples < 1 || s.samples > 65536) return usage(fmt::format("{} samples", s.samples), "from 1 to 65536");
    if (s.size < 0 || s.size > 8192)
        return usage(fmt::format("a map of {} texels", s.size), "from 1 to 8192, or 0: as it is");
    return {};
}

Result<OcclusionBake> startOcclusion(Document& document, const BakeSettings& settings) {
    if (Status s = checkBakeSettings(settings); !s) return s.error();
    if (!document.isOpen()) return failed("no project is open", "open or create one first");
    if (fieldEntity(document.project()).empty())
        return unsound("there is no GrassField to hold the ambient occlusion", "add an entity with a GrassField")
            .at(document.project().dir);
    if (const Terrain* t = findGround(document.project()).terrain; t && t->mapSize > 0 && t->size.x != t->size.y)
        return unsound("ambient occlusion is baked for the whole terrain, which a square of mapSize does not cover",
                       "set Terrain.mapSize to 0, or make the terrain square")
            .at(document.project().dir);
    const OcclusionSettings wanted = settingsOf(settings);
    const uint64_t hash = occlusionHash(document.project(), wanted);
    const auto copy = std::make_shared<Project>(snapshot(document.project(), document.tables().components));
    return OcclusionBake{settings, Job<Map>("ambient occlusion", hash, [copy, wanted, hash](JobControl& control) {
                             return occlusionOf(*copy, wanted, hash, control);
                         })};
}

std::optional<Status> finishOcclusion(Document& document, OcclusionBake& bake) {
    if (!bake.job.finished()) return {};
    std::optional<Result<Map>> made = bake.job.take(occlusionHash(document.project(), settingsOf(bake.settings)));
    if (!made)
        return failed("ambient occlusion was not baked: it was cancelled, or the scene changed meanwhile",
                      "bake again");
    if (!*made) return made->error();
    return useOcclusion(document, std::move(**made));
}

}  // namespace sward
