// How long somebody waits: from starting the program to a picture, and to a loaded project in a context.
// Processes of their own, because loading libraries and compiling programs are part of it.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "bench/limits.h"
#include "gpu/gpu.h"

namespace {
using namespace sward;

// Median seconds of five runs of `sward ARGS`; NaN if one fails.
double medianRun(const std::string& args) {
    const std::string command = SWARD_BINARY_DIR "/sward " + args + " >/dev/null";
    std::vector<double> runs;
    for (int i = 0; i < 5; ++i) {
        int code = 0;
        runs.push_back(seconds([&] { code = std::system(command.c_str()); }));
        if (code != 0) return std::nan("");
    }
    return median(runs);
}

// Median seconds of three starts of the editor on a project, until its first picture is on the screen; NaN without
// Xvfb.
double firstPicture(const std::string& project) {
    const std::string command =
        SWARD_SOURCE_DIR "/bench/first_picture.sh " SWARD_BINARY_DIR "/sward " + project + " 2>/dev/null";
    std::vector<double> runs;
    for (int i = 0; i < 3; ++i) {
        double s = std::nan("");
        if (FILE* told = popen(command.c_str(), "r")) {
            if (std::fscanf(told, "%lf", &s) != 1) s = std::nan("");
            pclose(told);
        }
        if (std::isnan(s)) return s;
        runs.push_back(s);
    }
    return median(runs);
}

SWARD_LIMITS("startup", [] {
    const std::string football = SWARD_SOURCE_DIR "/projects/football";
    const std::string picture = (std::filesystem::temp_directory_path() / "sward-bench-startup.png").string();
    // `check` starts, loads and needs no context; the context is added, made here.
    bool made = false;
    const double context = seconds([&] { made = static_cast<bool>(makeHeadlessGpu()); });
    reportLimit("startup: football loaded, and a context made",
                made ? medianRun("check " + football) + context : std::nan(""), 1, "s");
    reportLimit("startup: football at human as a PNG of 320x240",
                medianRun("render " + football + " --camera human --size 320x240 --out " + picture), 4, "s");
    std::filesystem::remove(picture);
    reportLimit("startup: window to the first picture of park, nothing cached",
                firstPicture(SWARD_SOURCE_DIR "/projects/park"), 3, "s");
});
}  // namespace
