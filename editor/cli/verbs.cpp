#include "app/templates.h"
#include "cli/cli.h"
#include "core/json.h"
#include "core/log.h"
#include "core/resources.h"
#include "maps/map_io.h"
#include "project/project_files.h"
#include "techniques.h"
#include "world/view_camera.h"

namespace sward {

namespace {

Status makeFrom(const NewCommand& o) {
    std::string known;
    for (const ProjectTemplate& t : projectTemplates(resource("projects/templates"))) {
        known += (known.empty() ? "" : ", ") + t.name;
        if (t.name == o.from)
            return makeProject(tables(), o.dir, t, {t.name, o.size.value_or(t.size), o.relief.value_or(t.relief)});
    }
    return usage(fmt::format("there is no template \"{}\"", o.from), "choose one of " + known);
}

Status makeBare(const std::string& dir) {
    const auto made = newProject(dir, tables().components);
    return made ? Status{} : Status{made.error()};
}

}  // namespace

int newVerb(const NewCommand& o) {
    if (const Status made = o.from.empty() ? makeBare(o.dir) : makeFrom(o); !made) return report(made.error());
    std::printf("%s: a new project; open it with: sward edit %s\n", o.dir.c_str(), o.dir.c_str());
    return 0;
}

int checkVerb(const std::string& dir, bool strict) {
    const CheckReport r = checkProject(dir, tables().components);
    for (const Error& e : r.refused) std::printf("refused: %s\n", e.text().c_str());
    for (const Fault& f : r.repaired) std::printf("repaired: %s: %s\n", f.where.c_str(), f.message.c_str());
    for (const Fault& f : r.noticed) std::printf("noticed: %s: %s\n", f.where.c_str(), f.message.c_str());
    if (!r.refused.empty() || (strict && !r.repaired.empty())) {
        std::printf("%s: %zu refused, %zu repaired\n", dir.c_str(), r.refused.size(), r.repaired.size());
        const bool busy = !r.refused.empty() && r.refused.front().code == ExitCode::Failed;  // it is being saved
        return static_cast<int>(busy ? ExitCode::Failed : ExitCode::Unsound);
    }
    std::printf("%s: sound%s\n", dir.c_str(),
                r.repaired.empty() ? "" : fmt::format(", {} repaired", r.repaired.size()).c_str());
    return 0;
}

int explainVerb(const std::string& dir, bool json) {
    auto project = loadProject(dir, tables().components);
    if (!project) return report(project.error());
    auto gpu = makeHeadlessGpu();
    if (!gpu) return report(gpu.error());
    // Drawn once at a small size, so that the memory told is what is really held.
    Renderer renderer(**gpu, tables());
    ViewSettings settings;
    settings.width = 64, settings.height = 48;
    const Camera* camera = findCamera(*project, "");
    if (Status s = renderer.draw(*project, camera ? viewOf(*camera) : ViewCamera{}, settings); !s)
        return report(s.error());
    std::printf("%s", renderer.explain(*project, json).c_str());
    return 0;
}

}  // namespace sward
