// project.json: whatever it holds, loading ends with a project or an error; a project that loads is written as text
// that loads again as the same.
#include "fuzz/scratch.h"
#include "project/project_files.h"
#include "project/project_json.h"
#include "techniques.h"

using namespace sward;

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, size_t size) {
    const auto file = fuzz::inputFile("p/project.json", fuzz::textOf(data, size));
    const auto rows = tables().components;
    const auto project = loadProject(file.parent_path(), rows);
    checkProject(file.parent_path(), rows);
    if (!project) return 0;
    const std::string text = writeJson(projectJson(*project, rows));
    test::writeText(file, text);
    const auto again = loadProject(file.parent_path(), rows);
    fuzz::promise(bool(again), "what was written is read");
    fuzz::promise(writeJson(projectJson(*again, rows)) == text, "what is read again is written as the same text");
    return 0;
}
