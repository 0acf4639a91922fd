// The cache of slices: with the right hash at its end, so that what lies before it is read; levels then have the sizes
// that they say.
#include "core/hash.h"
#include "fuzz/scratch.h"
#include "grass/slice_file.h"

using namespace sward;

namespace {
constexpr uint64_t kKey = 0x123456789abcdef0;  // that of the seed
}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, size_t size) {
    std::string bytes(fuzz::textOf(data, size));
    const uint64_t sum = hashBytes(bytes.data(), bytes.size());
    bytes.append(reinterpret_cast<const char*>(&sum), 8);
    test::writeText(sliceFile(fuzz::scratch(), kKey), bytes);
    const auto images = loadCachedSlices(fuzz::scratch(), kKey);
    if (!images) return 0;
    for (const auto* levels : {&images->vertical, &images->far})
        for (const SliceLevel& l : *levels)
            fuzz::promise(l.width > 0 && l.height > 0 && !l.threshold.empty() &&
                              l.threshold.size() % (4 * size_t(l.width) * size_t(l.height)) == 0,
                          "levels have whole layers");
    return 0;
}
