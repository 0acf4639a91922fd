// A save that was interrupted, as the next load finds it: its project.json, its list of what to remove, and what is to
// make the new end of a map count, parted by lines of "----". Whatever they hold, finishing the save touches nothing
// outside the project's folder.
#include "core/save_folder.h"
#include "fuzz/scratch.h"
#include "project/project_files.h"
#include "techniques.h"

using namespace sward;
namespace fs = std::filesystem;

namespace {
constexpr std::string_view kParting = "\n----\n";
}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, size_t size) {
    const std::string_view text = fuzz::textOf(data, size);
    std::string parts[3];
    for (size_t i = 0, begin = 0; i < 3 && begin <= text.size(); ++i) {
        const size_t end = std::min(text.find(kParting, begin), text.size());
        parts[i] = text.substr(begin, end - begin);
        begin = end + kParting.size();
    }
    const fs::path dir = fuzz::scratch() / "p", outside = fuzz::scratch() / "outside.png";
    test::writeText(outside, "kept");
    test::writeText(dir / "project.json", "{}");
    test::writeText(dir / "maps/a.png", "a map");
    test::writeText(dir / kSaveFolder / "project.json", parts[0]);
    test::writeText(dir / kSaveFolder / ".removed", parts[1]);
    if (!parts[2].empty()) test::writeText(dir / kSaveFolder / "maps/a.png.sward-switch", parts[2]);
    const auto project = loadProject(dir, tables().components);
    fuzz::promise(test::readText(outside) == "kept", "nothing outside the project's folder is touched");
    fuzz::promise(fs::exists(dir / "project.json"), "a project stays a project");
    std::error_code gone;
    if (const auto kept = fs::file_size(dir / "maps/a.png", gone); !gone)
        fuzz::promise(kept == 5, "a switch changes a number and no more");
    std::error_code ignored;
    fs::remove_all(dir, ignored);
    return 0;
}
