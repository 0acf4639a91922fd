// Results that are read back: a machine's part of a reference, and a sweep's cost.json, which is written again as it
// was read.
#include "core/json.h"
#include "cost/cost_files.h"
#include "fuzz/scratch.h"
#include "reference/reference_part.h"

using namespace sward;

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, size_t size) {
    const std::string_view text = fuzz::textOf(data, size);
    const auto part = readPart(fuzz::inputFile("part", text));
    if (part) fuzz::promise(encodePart(*part) == text, "a part that is read is written as the same bytes");
    const auto tree = parseJson(text, "cost.json");
    if (!tree) return 0;
    const auto run = costFrom(*tree, "cost.json");
    if (!run) return 0;
    const std::string written = writeJson(costJson(*run));
    const auto again = costFrom(*parseJson(written, "cost.json"), "cost.json");
    fuzz::promise(bool(again), "what was written is read");
    fuzz::promise(writeJson(costJson(*again)) == written, "what is read again is written as the same text");
    return 0;
}
