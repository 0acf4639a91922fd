#include "cli/cli.h"

#include "techniques.h"

#include <CLI/CLI.hpp>

#include "core/log.h"
#include "cost/cost_settings.h"
#include "cost/effect_probe.h"
#include "model/bakes.h"

namespace sward {
namespace {

int exitCode(ExitCode c) { return static_cast<int>(c); }

// Of an option: CLI11 reads "nan" and "inf" as numbers.
const CLI::Validator kFinite(
    [](const std::string& text) {
        return std::isfinite(std::strtod(text.c_str(), nullptr))
                   ? std::string()
                   : "\"" + text + "\" is no number of seconds; write one such as 1.5";
    },
    "");
const CLI::Validator kRate(
    [](const std::string& text) {
        const double value = std::strtod(text.c_str(), nullptr);
        return std::isfinite(value) && value > 0
                   ? std::string()
                   : "\"" + text + "\" is no rate; write pictures a second, above 0, such as 25";
    },
    "");
const CLI::Validator kSamples(
    [](const std::string& text) {
        return text == "1" || text == "2" || text == "4" || text == "8"
                   ? std::string()
                   : "\"" + text + "\" is no number of samples; write 1, 2, 4 or 8";
    },
    "");

struct Verbs {
    CLI::App app{"Sward: an editor and renderer for grass and forest", "sward"};
    int result = 0;
    RenderOptions render;
    ReferenceOptions reference;
    MergeCommand merge;
    CostOptions cost;
    FitOptions fit;
    EffectOptions effects;
    CompareOptions compare;
    ImportCommand import;
    ExportCommand exported;
    BakeCommand bake;
    PictureOptions pictures;
    HardCasesOptions cases;
    TransitionOptions transitions;
    NewCommand made;
    ScriptOptions script;
    std::string project, widgets, dir;
    bool strict = false, judged = false, json = false, verbose = false;

    CLI::App* verb(const char* name, const char* help, std::function<int()> run) {
        CLI::App* v = app.add_subcommand(name, help);
        v->callback([this, run = std::move(run)] {
            setLogVerbose(verbose);
            result = run();
        });
        return v;
    }

    static void addViews(CLI::App* v, RenderOptions& o) {
        v->add_option("project", o.project, "folder of the project")->required();
        v->add_option("--camera", o.camera, "name of one camera (default: all)");
        v->add_option("--path", o.path, "name of a CameraPath to film along, instead of cameras");
        v->add_option("--size", o.size, "WxH in pixels (default: 1024x768)");
        v->add_option("--technique", o.technique, techniqueNames(tables().techniques) + " (default: the project's)");
        v->add_option("--set", o.set, "PATH=VALUE overrides a field; may be repeated")->allow_extra_args(false);
        v->add_option("--view", o.view, "final, tiers, overdraw, density, depth or normals");
        v->add_option("--msaa", o.msaa, "samples a pixel: 1, 2, 4 or 8 (default: 4; clamped to the driver's)")
            ->check(kSamples);
        v->add_option("--time", o.time, "scene time in seconds (default: 0)")->check(kFinite);
        v->add_option("--frames", o.frames, "measure N frames after 3 warm-ups; with --fps write them");
        v->add_option("--fps", o.fps,
                      "with --frames or --path: write frame_0000.png and so on at this rate (along a path 25)")
            ->check(kRate);
        v->add_option("--out", o.out, "file (one camera) or folder (several); .png or .exr");
        v->add_option("--stats", o.stats, "write statistics as JSON to this file");
    }
    void addRender() {
        CLI::App* v = verb("render", "Draw a project's cameras to images", [this] { return renderVerb(render); });
        addViews(v, render);
        v->add_option("--first", render.first, "with --fps: begin with frame I of the film, numbered so (default: 0)")
            ->check(CLI::NonNegativeNumber);
    }
    void addReference() {
        CLI::App* v =
            verb("reference", "Ray-trace the truth of the same cameras", [this] { return referenceVerb(reference); });
        addViews(v, reference);
        v->add_option("--samples", reference.samples, "rays a pixel (default: 16)");
        v->add_option("--lighting", reference.lighting,
                      "full, or direct: lit as techniques light, only shadows traced");
        v->add_option("--shard", reference.shard, "I/N: this machine's share of the image, as a part for merge");
        v->add_option("--seed", reference.seed, "of the rays, never of the scene (default: 1)");
        CLI::App* m = verb("merge", "Join the parts of a sharded run", [this] { return mergeVerb(merge); });
        m->add_option("part", merge.parts, "files that --shard wrote")->required();
        m->add_option("--out", merge.out, "file of the whole")->required();
    }
    static void addTruth(CLI::App* v, CostOptions& o) {
        v->add_option("project", o.project, "folder of the project")->required();
        v->add_option("--camera", o.camera, "name of one camera (default: all)");
        CLI::Option* path = v->add_option("--path", o.path, "name of a CameraPath: moments of it, instead of cameras");
        v->add_option("--frames", o.frames, "with --path: how many moments (default: 5)")->needs(path);
        v->add_option("--fps", o.fps,
                      "with --path: so many moments a second from its beginning (default: evenly over all of it)")
            ->needs(path)
            ->check(kRate);
        v->add_option("--size", o.size, "WxH in pixels (default: 1024x768)");
        v->add_option("--set", o.set, "PATH=VALUE overrides a field; may be repeated")->allow_extra_args(false);
        v->add_option("--time", o.time, "scene time in seconds (default: 0)")->check(kFinite);
        v->add_option("--samples", o.samples, "rays a pixel of the truth (default: 32)");
        v->add_option("--lighting", o.lighting,
                      "of the truth: full, or direct (lit as techniques light, only shadows traced)");
        v->add_option("--seed", o.seed, "of the truth's rays, never of the scene (default: 1)");
    }
    void addCost() {
        CLI::App* c = verb("cost", "What accuracy costs in time: techniques and settings against the ray-traced truth",
                           [this] { return costVerb(cost); });
        addTruth(c, cost);
        c->get_option("project")->required(false);
        c->get_option("--size")->description(
            "WxH in pixels, or several: WxH,WxH, each into its own folder (default: 1024x768)");
        CLI::Option* numerics = c->add_flag(
            "--numerics", cost.numerics,
            "the price of formulas: each form's error and time, on the CPU and in a shader; needs no project");
        c->add_flag("--json", cost.json, "with --numerics: print JSON")->needs(numerics);
        c->add_option("--technique", cost.technique,
                      "sweep one alone beside the project as it is: " + sweptNames(tables()) + " (default: all)");
        c->add_option("--out", cost.out,
                      "folder for table, plots and report; run again, it goes on where it stopped; with --numerics for "
                      "numerics.csv and numerics.json");
        c->add_option("--rounds", cost.rounds, "of timing, over all rows in turn (default: 5)");
        c->add_option("--max-ms", cost.maxMs,
                      "rows that take longer are left out and listed (default: twice what the project as it is takes, "
                      "at least 250)");
        c->add_option("--shard", cost.shard, "I/N: this machine's share of the rows, for merge");
        CLI::App* f = verb("fit", "The settings with the least appearance error within a budget of time",
                           [this] { return fitVerb(fit); });
        addTruth(f, fit);
        f->add_option("--budget-ms", fit.budgetMs, "milliseconds a frame may take, at the slowest camera")->required();
        f->add_option(
            "--technique", fit.technique,
            "turn one alone: " + sweptNames(tables()) + " (default: those of grass; of forests without grass)");
        f->add_option("--candidates", fit.candidates,
                      "settings that the search may try beside the grid's 27 (default: 40)");
        f->add_option("--seconds", fit.seconds, "that it may take in all, or little more (default: no limit)");
        f->add_option("--so-far", fit.soFar, "a file that gets the best so far, as --json would print it");
        f->add_flag("--write", fit.write, "save the settings in the project");
        f->add_flag("--json", fit.json, "print JSON");
    }
    void addEffects() {
        CLI::App* v = verb("effects", "Where each effect changes the picture, and what it costs: what is never seen",
                           [this] { return effectsVerb(effects); });
        v->add_option("project", effects.project, "folder of the project")->required();
        v->add_option("--camera", effects.camera, "name of one camera (default: all)");
        v->add_option("--size", effects.size, "WxH in pixels (default: 1024x768)");
        v->add_option("--technique", effects.technique,
                      techniqueNames(tables().techniques) + " (default: the project's)");
        v->add_option("--set", effects.set, "PATH=VALUE overrides a field; may be repeated")->allow_extra_args(false);
        v->add_option("--msaa", effects.msaa, "samples a pixel: 1, 2, 4 or 8 (default: 4; clamped to the driver's)")
            ->check(kSamples);
        v->add_option("--time", effects.time, "scene time in seconds (default: 0)")->check(kFinite);
        v->add_option("--pairs", effects.pairs,
                      "frames with and without each effect that are timed (default: 7, whose interval is 98% sure)")
            ->check(CLI::Range(1, kMostPairs));
        v->add_option("--out", effects.out, "folder for effects.json and, a camera each, a picture an effect");
        v->add_flag("--json", effects.json, "print JSON");
    }
    void addCompare() {
        CLI::App* v =
            verb("compare",
                 "Metrics of two images of the same size, or of two folders with the pictures of a film: what pops",
                 [this] { return compareVerb(compare); });
        v->add_option("a", compare.a, "first image, or folder")->required();
        v->add_option("b", compare.b, "second image, or folder: the truth")->required();
        v->add_option("--mask", compare.mask,
                      "image whose first channel says how much of each pixel is grass and counts");
        v->add_option("--heatmap", compare.heatmap, "write a map of the errors to this .png");
        v->add_option("--metric", compare.metric, "of the heat map: appearance (default), flip, rmse or ssim");
        v->add_option("--ppd", compare.ppd, "pixels per degree of the viewer's field of view, for FLIP (default: 67)");
        v->add_flag("--json", compare.json, "print JSON");
        v->add_flag("--linear", compare.linear, "compare EXR values as they are, without tone mapping");
    }
    void addTransitions() {
        TransitionOptions& o = transitions;
        CLI::App* v = verb("transitions", "What pops along a camera's path, against other blades of the field",
                           [this] { return transitionsVerb(transitions); });
        v->add_option("project", o.project, "folder of the project")->required();
        v->add_option("--path", o.path, "name of the CameraPath that is walked")->required();
        v->add_option("--pictures", o.pictures, "how many, evenly over all of it (default: 25)");
        v->add_option("--from", o.from, "second of the path at which it begins (default: 0)");
        v->add_option("--to", o.to, "second of the path at which it ends (default: its end)");
        v->add_option("--size", o.size, "WxH in pixels (default: 160x120)");
        v->add_option("--samples", o.samples, "rays a pixel of the truth (default: 4)");
        v->add_option("--technique", o.technique, techniqueNames(tables().techniques) + " (default: the project's)");
        v->add_option("--set", o.set, "PATH=VALUE overrides a field; may be repeated")->allow_extra_args(false);
        v->add_option("--time", o.time, "scene time in seconds, at which it stands still (default: 0)")->check(kFinite);
        v->add_option("--out", o.out, "file for the graph, .png or .svg");
        v->add_flag("--json", o.json, "print JSON");
    }
    void addMaps() {
        CLI::App* in = verb("import", "Read a map of a project from a file, and save the project",
                            [this] { return importVerb(import); });
        in->add_option("project", import.project, "folder of the project")->required();
        in->add_option("map", import.map, "the map's PATH, or an unambiguous tail of it")->required();
        in->add_option("file", import.file, "EXR, PNG 8/16, TIFF, or R16 with its JSON sidecar")->required();
        in->add_flag("--flip", import.flip, "the file's first row is the far edge");
        in->add_flag("--packed", import.packed, "red is the density, blue the blades' height (project/packed_map.h)");
        in->add_option("--range", import.range, "LOW,HIGH: what 0 and full scale mean");
        addExport();
    }
    void addExport() {
        CLI::App* out = verb("export", "Write the scene to a .glb, or one map of a project to an image file",
                             [this] { return exportVerb(exported); });
        out->add_option("project", exported.project, "folder of the project")->required();
        CLI::Option* map = out->add_option("--map", exported.map,
                                           "the map's PATH, or an unambiguous tail of it (default: the whole scene)");
        out->add_option("--out", exported.out, "file: .glb for the scene; EXR, PNG, TIFF or R16 for a map")->required();
        out->add_flag("--flip", exported.flip, "write the map's far edge first")->needs(map);
        out->add_flag("--packed", exported.packed,
                      "the map's density, its coarse version and blade heights as red, green and blue")
            ->needs(map);
        out->add_option("--blades-within", exported.bladesWithin,
                        "of the scene: only grass and flowers within so many metres of the camera")
            ->excludes(map);
        out->add_option("--camera", exported.camera,
                        "the camera that --blades-within measures from (default: the first)")
            ->excludes(map);
        out->add_option("--stats", exported.stats, "write what the .glb holds as JSON to this file")->excludes(map);
    }
    void addBakes() {
        CLI::App* v = verb("bake", "Make what is made ahead, and save the project (default: all of it)",
                           [this] { return bakeVerb(bake); });
        v->add_option("project", bake.project, "folder of the project")->required();
        for (const BakeRow& row : bakeRows())
            v->add_flag_callback(
                std::string("--") + row.flag, [this, &row] { bake.only.push_back(row.flag); }, row.help);
        v->add_option("--samples", bake.samples, "rays a texel (default: 64)");
        v->add_option("--size", bake.size, "texels along the longer side (default: as it is, else 512)");
    }
    void addCheck() {
        CLI::App* v = verb("check", "Load everything and report every fault; or hold pictures against accepted ones",
                           [this] { return judged ? pictureVerb(pictures) : checkVerb(pictures.project, strict); });
        v->add_option("project", pictures.project, "folder of the project")->required();
        CLI::Option* repaired = v->add_flag("--strict", strict, "what was repaired is a fault too");
        CLI::Option* on = v->add_flag("--pictures", judged,
                                      "draw each camera's accepted picture anew and judge it by its tolerances: exit 1 "
                                      "where one differs")
                              ->excludes(repaired);
        v->add_flag("--accept", pictures.accept, "make the pictures the accepted ones, and save the project")
            ->needs(on);
        v->add_option("--camera", pictures.camera, "name of one camera (default: all)")->needs(on);
        v->add_option("--size", pictures.size, "with --accept: WxH (default: as the camera's is, else 640x360)")
            ->needs(on);
        v->add_option("--time", pictures.time, "with --accept: scene time in seconds (default: as it is, else 0)")
            ->needs(on)
            ->check(kFinite);
        v->add_option("--out", pictures.out,
                      "folder for pictures that differ: NAME.png, NAME.accepted.png, NAME.difference.png")
            ->needs(on);
        v->add_flag("--json", pictures.json, "print JSON")->needs(on);
    }
    void addHardCases() {
        CLI::App* v =
            verb("hardcases", "Run every numerical hard case on this machine", [this] { return hardcasesVerb(cases); });
        CLI::Option* asJson = v->add_flag("--json", cases.json, "print JSON");
        CLI::Option* curve =
            v->add_option("--curve", cases.curve, "one case (B-1; B-1.2 for its second row) along what makes it hard")
                ->excludes(asJson);
        v->add_option("--out", cases.out, "with --curve: file for it, .png, .svg or .csv (default: printed)")
            ->needs(curve);
    }
    void addProjects() {
        CLI::App* edit = verb("edit", "Open the editor (default)", [this] { return editVerb(project, widgets); });
        edit->add_option("project", project, "folder of the project");
        edit->add_option("--widgets", widgets, "a file that gets, after each frame, where each widget is");
        CLI::App* fresh = verb("new", "Make a project: one terrain, one field, a sun, a camera; or from a template",
                               [this] { return newVerb(made); });
        fresh->add_option("dir", made.dir, "folder to make")->required();
        auto* from = fresh->add_option("--template", made.from, "field, hills, pitch or pond");
        fresh->add_option("--size", made.size, "metres of the terrain each way")->needs(from);
        fresh->add_option("--relief", made.relief, "metres between the lowest and the highest ground")->needs(from);
        addCheck();
        CLI::App* explain = verb("explain", "Which features a scene has, what each makes run, and why",
                                 [this] { return explainVerb(dir, json); });
        explain->add_option("project", dir, "folder of the project")->required();
        explain->add_flag("--json", json, "print JSON");
        addHardCases();
        CLI::App* s = verb("script", "Run an editor script", [this] { return scriptVerb(script); });
        s->add_option("file", script.file, "Lua file")->required();
        s->add_option("--project", script.project, "project to open first");
        s->add_flag("--window", script.window, "show the editor's window while it runs");
        s->add_option("--size", script.size, "WxH of the editor without a window (default: 1280x800)");
        s->add_option("--density", script.density, "its pixels a point, as on a dense screen (default: 1)")
            ->check(CLI::Range(1.0, 4.0));
    }
    Verbs() {
        app.set_version_flag("--version", std::string("sward ") + SWARD_VERSION);
        app.add_flag("--verbose", verbose, "say what is being done")->configurable(false);
        addProjects();
        addRender();
        addReference();
        addCost();
        addEffects();
        addCompare();
        addTransitions();
        addMaps();
        addBakes();
        app.require_subcommand(0, 1);
    }
};

}  // namespace

int report(const Error& error) {
    logError(error.text());
    return exitCode(error.code);
}

int runCommandLine(int argc, char** argv) {
    Verbs verbs;
    try {
        verbs.app.parse(argc, argv);
        return verbs.app.get_subcommands().empty() ? editVerb(verbs.project) : verbs.result;
    } catch (const CLI::ParseError& e) {
        return verbs.app.exit(e) == 0 ? 0 : exitCode(ExitCode::Usage);
    }
}

}  // namespace sward
