// A save that was interrupted, as the next load finds it: its project.json and its list of what to remove, parted by a
// line of "----". Whatever they hold, finishing the save touches nothing outside the project's folder.
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
    const size_t at = std::min(text.find(kParting), text.size());
    const fs::path dir = fuzz::scratch() / "p", outside = fuzz::scratch() / "outside.png";
    test::writeText(outside, "kept");
    test::writeText(dir / "project.json", "{}");
    test::writeText(dir / "maps/a.png", "a map");
    test::writeText(dir / kSaveFolder / "project.json", std::string(text.substr(0, at)));
    test::writeText(dir / kSaveFolder / ".removed",
                    std::string(text.substr(std::min(at + kParting.size(), text.size()))));
    const auto project = loadProject(dir, tables().components);
    fuzz::promise(test::readText(outside) == "kept", "nothing outside the project's folder is touched");
    fuzz::promise(fs::exists(dir / "project.json"), "a project stays a project");
    std::error_code ignored;
    fs::remove_all(dir, ignored);
    return 0;
}
