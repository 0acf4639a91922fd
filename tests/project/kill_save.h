// Kills a process that saves a project over and over, and looks at what is left: for the tests (50 times) and the
// benchmarks (1000 times). The executable's main must call childMain (tests/child.h).
#pragma once
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <string>
#include <thread>

#include "project/project_files.h"
#include "scene/project.h"
#include "techniques.h"
#include "tests/child.h"

namespace sward::test {

// The two states of the killed project: in state b the density is 0.5, the name "b", and a height map is there.
inline Project killState(const std::filesystem::path& dir, bool b) {
    Project p;
    p.dir = dir;
    p.name = b ? "b" : "a";
    const auto filled = [](float v, PixelType type) {
        Map map({160, 160, 1, type});
        for (int y = 0; y < 160; ++y)
            for (int x = 0; x < 160; ++x) map.set(x, y, 0, v);
        return map;
    };
    Terrain terrain;
    if (b) terrain.height = {"maps/ground.height.exr", filled(7, PixelType::F32)};
    GrassField field;
    field.species[0].density = {"maps/lawn.grass.density.png", filled(b ? 0.5f : 1.0f, PixelType::U16)};
    field.vegetation = {"maps/lawn.vegetation.png", Map({32, 32, 4, PixelType::U8})};
    field.vegetation.map.set(3, 3, 0, b ? 1.0f : 0.0f);
    p.registry.add<Terrain>(*addEntity(p, "ground"), std::move(terrain));
    p.registry.add<GrassField>(*addEntity(p, "lawn"), std::move(field));
    return p;
}

// Empty if the project at dir is state a or state b from one end to the other; else what is wrong.
inline std::string faultOf(const std::filesystem::path& dir) {
    LoadReport report;
    Result<Project> p = loadProject(dir, tables().components, &report);
    if (!p) return "unreadable: " + p.error().text();
    if (!report.repaired.empty()) return "repaired: " + report.repaired[0].where + report.repaired[0].message;
    if (p->name != "a" && p->name != "b") return "named \"" + p->name + "\"";
    const Project expected = killState(dir, p->name == "b");
    const auto& field = *p->registry.get<GrassField>(findEntity(*p, "lawn"));
    const auto& wanted = *expected.registry.get<GrassField>(findEntity(expected, "lawn"));
    if (field.species[0].density.map.hash() != wanted.species[0].density.map.hash())
        return "mixed: density of the other state than " + p->name;
    if (field.vegetation.map.hash() != wanted.vegetation.map.hash())
        return "mixed: vegetation of the other state than " + p->name;
    if (p->registry.get<Terrain>(findEntity(*p, "ground"))->height.present() != (p->name == "b"))
        return "mixed: heights of the other state than " + p->name;
    return {};
}

// Saves the two states in turn until it is killed; writes a byte once it begins.
inline const ChildFunctionRow kSaveInTurn("save-in-turn", [](const std::vector<std::string>& args) -> std::string {
    const Project states[] = {killState(args.at(0), false), killState(args.at(0), true)};
    if (write(STDOUT_FILENO, ".", 1) != 1) return "nobody listens";
    for (int n = std::stoi(args.at(1));; ++n)
        if (const auto saved = saveProject(states[n % 2], tables().components); !saved) return saved.error().text();
});

// Starts `times` children that save the two states in turn, kills each after up to `longestMs`, and loads what it left.
// Returns how many left an unsound or mixed project; `why`: the first.
inline int killSaveLoop(int times, const std::filesystem::path& dir, std::string* why, unsigned seed = 1,
                        int longestMs = 40) {
    if (!saveProject(killState(dir, false), tables().components)) return times;
    std::mt19937 random(seed);
    int faults = 0;
    for (int i = 0; i < times; ++i) {
        const Child child = startChild("save-in-turn", {dir.string(), std::to_string(i)});
        char begun = 0;
        const bool began = read(child.output, &begun, 1) == 1;
        std::this_thread::sleep_for(std::chrono::microseconds(random() % (unsigned(longestMs) * 1000)));
        kill(child.pid, SIGKILL);
        const std::string said = finishChild(child);
        const std::string fault =
            !began || said != "the child crashed" ? "the child could not save: " + said : faultOf(dir);
        if (fault.empty()) continue;
        if (faults++ == 0 && why) *why = "kill " + std::to_string(i) + ": " + fault;
    }
    return faults;
}

}  // namespace sward::test
