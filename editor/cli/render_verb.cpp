#include <chrono>

#include "cli/cli.h"
#include "core/file.h"
#include "core/log.h"
#include "cost/frame_estimate.h"
#include "cost/frame_stats.h"
#include "maps/map_io.h"
#include "project/project_files.h"
#include "techniques.h"
#include "world/drawn_project.h"
#include "world/view_camera.h"

namespace sward {
namespace fs = std::filesystem;

Result<std::pair<int, int>> parseSize(const std::string& text) {
    int w = 0, h = 0;
    char rest = 0;
    if (std::sscanf(text.c_str(), "%dx%d%c", &w, &h, &rest) != 2 || w < 1 || h < 1 || w > 16384 || h > 16384)
        return usage("\"" + text + "\" is no size", "write WIDTHxHEIGHT, each from 1 to 16384, such as 1024x768");
    return std::pair{w, h};
}

fs::path outputOf(const RenderOptions& o, const Project& p, const std::string& camera, bool several) {
    if (o.out.empty()) return p.name + "-" + camera + ".png";
    return several ? fs::path(o.out) / (camera + ".png") : fs::path(o.out);
}

namespace {

Result<ViewMode> parseView(const std::string& text) {
    for (size_t i = 0; i < std::size(kViewModes); ++i)
        if (text == kViewModes[i]) return static_cast<ViewMode>(i);
    return usage("there is no view \"" + text + "\"", "final, tiers, overdraw, density, depth or normals");
}

Status setTechnique(Project& p, const std::string& name) {
    if (name.empty()) return {};
    for (const auto& [entity, e] : p.entities) {
        if (!p.registry.get<GrassField>(e)) continue;
        auto f = findField(p, tables().components, entity + ".GrassField.technique");
        if (!f) return f.error();
        if (Status s = setFieldText(*f, name); !s) return s;
    }
    return {};
}

Status applyOverride(Project& p, const std::string& text) {
    const size_t equals = text.find('=');
    if (equals == std::string::npos) return usage("--set " + text + " has no '='", "write PATH=VALUE");
    auto f = findField(p, tables().components, text.substr(0, equals));
    if (!f) return f.error();
    return setFieldText(*f, text.substr(equals + 1));
}

Status writePicture(const Renderer& r, const fs::path& file, int w, int h) {
    if (Status s = makeFolderOf(file); !s) return s;
    if (file.extension() == ".exr") return writeImageExr(file, w, h, 3, r.readLinear());
    if (file.extension() == ".png") return writeImagePng(file, w, h, 3, r.readImage());
    return usage("images are written as .png or .exr", "name --out so").at(file);
}

struct Drawing {
    Renderer& renderer;
    const Project& project;
    const Gpu& gpu;
    ViewCamera view;
    ViewSettings settings;
};

Result<FrameRecord> measure(Drawing& shot, const std::string& camera, int frames) {
    FrameRecord record;
    record.camera = camera;
    ViewSettings s = shot.settings;
    for (int i = 0; i < 3 + frames; ++i) {
        const auto start = std::chrono::steady_clock::now();
        if (Status st = shot.renderer.draw(shot.project, shot.view, s); !st) return st.error();
        shot.renderer.finish();
        if (i >= 3)
            record.frameMs.push_back(
                std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
    }
    s.measure = true;
    if (Status st = shot.renderer.draw(shot.project, shot.view, s); !st) return st.error();
    record.stats = shot.renderer.stats();
    DrawnProject drawn;
    record.forests = countForests(drawn.of(shot.project, tables().components));
    record.stats.bladesVisible = visibleBlades(shot.project, tables(), shot.view, s.width, s.height);
    return record;
}

Status writeFilm(Drawing& shot, const RenderOptions& o, const std::string& name, const fs::path& folder, int w, int h) {
    for (int i = o.first; i < o.first + o.frames; ++i) {
        shot.settings.time = o.time + i / o.fps;
        shot.view = shotAt(o, shot.project, name, i / o.fps);
        // What adds up has nothing before the first picture.
        const auto drawn = i == o.first ? drawSettled(shot.renderer, shot.project, shot.view, shot.settings)
                                        : shot.renderer.draw(shot.project, shot.view, shot.settings);
        if (!drawn) return drawn;
        if (Status s = writePicture(shot.renderer, folder / fmt::format("frame_{:04d}.png", i), w, h); !s) return s;
    }
    return {};
}

// Before the work begins: that it will be long, and what makes it short. Ctrl+C ends it.
void tellOfLongFrames(const Drawing& shot, const std::string& camera) {
    if (!shot.gpu.software) return;
    const ViewSettings& s = shot.settings;
    if (const std::string told = longFrameText(shot.project, tables(), shot.view, s.width, s.height, camera);
        !told.empty())
        logWarning(told + " (--set it, or choose --technique; Ctrl+C ends this)");
}

Status renderAll(RenderOptions o, const Project& project, Gpu& gpu, int w, int h, ViewMode mode) {
    const auto cameras = shotNames(o, project);
    if (!cameras) return cameras.error();
    Renderer renderer(gpu, tables());
    const bool several = cameras->size() > 1;
    std::vector<FrameRecord> records;
    for (const std::string& name : *cameras) {
        Drawing shot{renderer, project, gpu, shotAt(o, project, name, 0), {}};
        shot.settings.width = w, shot.settings.height = h;
        shot.settings.msaa = o.msaa, shot.settings.mode = mode, shot.settings.time = o.time;
        const fs::path file = outputOf(o, project, name, several);
        tellOfLongFrames(shot, name);
        if (o.fps > 0 && o.frames > 0) {
            if (Status s = writeFilm(shot, o, name, several ? fs::path(o.out) / name : fs::path(o.out), w, h); !s)
                return s;
            continue;
        }
        if (!o.stats.empty() || o.frames > 0) {
            auto record = measure(shot, name, std::max(o.frames, 1));
            if (!record) return record.error();
            records.push_back(std::move(*record));
        }
        if (Status s = drawSettled(renderer, project, shot.view, shot.settings); !s) return s;
        if (Status s = writePicture(renderer, file, w, h); !s) return s;
        std::printf("%s\n", file.string().c_str());
    }
    if (o.stats.empty()) return {};
    return writeFileAtomic(o.stats, frameStatsJson(records, project, gpu, w, h, gpu.samplesFor(o.msaa)));
}

}  // namespace

Result<Project> openForRendering(const RenderOptions& o) {
    auto project = loadProject(o.project, tables().components);
    if (!project) return project;
    for (const std::string& s : o.set)
        if (Status st = applyOverride(*project, s); !st) return st.error();
    if (Status s = setTechnique(*project, o.technique); !s) return s.error();
    for (const auto& [name, e] : project->entities)
        for (const ComponentRow& row : tables().components)
            if (void* c = row.edit(project->registry, e))
                for (const std::string& said : repairComponent(row, c)) logWarning(name + "." + row.name + ": " + said);
    return project;
}

int renderVerb(const RenderOptions& o) {
    auto size = parseSize(o.size);
    if (!size) return report(size.error());
    auto mode = parseView(o.view);
    if (!mode) return report(mode.error());
    if (o.frames < 0) return report(usage("--frames takes a number from 0"));
    auto project = openForRendering(o);
    if (!project) return report(project.error());
    auto gpu = makeHeadlessGpu();
    if (!gpu) return report(gpu.error());
    if (Status s = renderAll(o, *project, **gpu, size->first, size->second, *mode); !s) return report(s.error());
    return 0;
}

}  // namespace sward
