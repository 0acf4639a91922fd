// Heads of PNG, EXR and TIFF: a size within what the file may have, or an error.
#include "fuzz/scratch.h"
#include "maps/image_head.h"

using namespace sward;

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, size_t size) {
    const auto head = readImageHead(fuzz::inputFile("image", fuzz::textOf(data, size)));
    if (head) fuzz::promise(!head->format.empty(), "a head that is read names its format");
    return 0;
}
