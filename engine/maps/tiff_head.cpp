// The first directory of a TIFF or BigTIFF: its size, and whether its strips or tiles lie within the file.
// Source: TIFF 6.0 (Adobe 1992), section 2; BigTIFF as libtiff reads it; GDAL's tag for what has no data (42113).
#include <algorithm>
#include <cstdlib>
#include <map>

#include "core/file.h"
#include "maps/image_head.h"
#include "maps/map.h"

namespace sward {
namespace {

constexpr uint64_t kMaxValues = 1 << 20;  // strips or tiles of one image; 16384 rows have fewer
enum Tag : uint16_t {
    kWidth = 256,
    kHeight = 257,
    kBits = 258,
    kCompression = 259,
    kStripOffsets = 273,
    kSamples = 277,
    kStripBytes = 279,
    kTileOffsets = 324,
    kTileBytes = 325,
    kNoData = 42113  // a number as text
};

struct Tiff {
    std::istream& in;
    uint64_t size;
    bool big = false;       // 64-bit offsets
    bool reversed = false;  // big-endian
    bool ok = true;         // false once a read lay outside the file

    uint64_t number(uint64_t at, int bytes) {
        unsigned char b[8] = {};
        in.clear();
        in.seekg(static_cast<std::streamoff>(at));
        if (at > size || size - at < uint64_t(bytes) || !in.read(reinterpret_cast<char*>(b), bytes)) ok = false;
        uint64_t value = 0;
        for (int i = 0; i < bytes; ++i) value = value << 8 | b[reversed ? i : bytes - 1 - i];
        return value;
    }
};

struct Entry {
    uint64_t count = 0;
    int bytes = 0;        // of one value
    uint64_t values = 0;  // where the values lie
};

int valueBytes(uint64_t type) {
    switch (type) {
        case 1:
        case 2:
            return 1;  // BYTE, ASCII
        case 3:
            return 2;  // SHORT
        case 4:
            return 4;  // LONG
        case 16:
            return 8;  // LONG8
        default:
            return 0;
    }
}

std::map<uint64_t, Entry> readDirectory(Tiff& t) {
    std::map<uint64_t, Entry> entries;
    const int offset = t.big ? 8 : 4, entrySize = t.big ? 20 : 12, countSize = t.big ? 8 : 2;
    const uint64_t directory = t.number(t.big ? 8 : 4, offset);
    const uint64_t n = t.number(directory, countSize);
    for (uint64_t i = 0; t.ok && i < std::min<uint64_t>(n, 4096); ++i) {
        const uint64_t at = directory + uint64_t(countSize) + i * uint64_t(entrySize);
        Entry e;
        e.bytes = valueBytes(t.number(at + 2, 2));
        e.count = t.number(at + 4, offset);
        e.values = at + 4 + uint64_t(offset);
        if (e.bytes > 0 && e.count > uint64_t(offset) / uint64_t(e.bytes)) e.values = t.number(e.values, offset);
        if (e.bytes > 0) entries.emplace(t.number(at, 2), e);
    }
    return entries;
}

uint64_t first(Tiff& t, const std::map<uint64_t, Entry>& entries, Tag tag, uint64_t absent) {
    const auto it = entries.find(tag);
    return it == entries.end() ? absent : t.number(it->second.values, it->second.bytes);
}

std::optional<double> noDataOf(Tiff& t, const std::map<uint64_t, Entry>& entries) {
    const auto it = entries.find(kNoData);
    if (it == entries.end()) return {};
    std::string text;
    for (uint64_t i = 0; i < std::min<uint64_t>(it->second.count, 64); ++i)
        text += static_cast<char>(t.number(it->second.values + i, 1));
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    return t.ok && end != text.c_str() ? std::optional(value) : std::nullopt;
}

// Whether every piece lies within the file, and uncompressed pieces hold all texels.
bool piecesFit(Tiff& t, const std::map<uint64_t, Entry>& entries, uint64_t texelBits, uint64_t texels) {
    const bool tiled = entries.contains(kTileOffsets);
    const auto offsets = entries.find(tiled ? kTileOffsets : kStripOffsets),
               sizes = entries.find(tiled ? kTileBytes : kStripBytes);
    if (offsets == entries.end() || sizes == entries.end()) return false;
    if (offsets->second.count != sizes->second.count || sizes->second.count > kMaxValues) return false;
    uint64_t total = 0;
    for (uint64_t i = 0; t.ok && i < sizes->second.count; ++i) {
        const uint64_t at =
            t.number(offsets->second.values + i * uint64_t(offsets->second.bytes), offsets->second.bytes);
        const uint64_t bytes = t.number(sizes->second.values + i * uint64_t(sizes->second.bytes), sizes->second.bytes);
        if (at > t.size || bytes > t.size - at) return false;
        total += bytes;
    }
    const bool plain = first(t, entries, kCompression, 1) == 1;
    return t.ok && (!plain || total >= texels * texelBits / 8);
}

}  // namespace

Result<ImageHead> readTiffHead(const std::filesystem::path& file, std::istream& in, uint64_t size) {
    const auto refuse = [&](const char* what) { return unsound(what, "export it again").at(file); };
    Tiff t{in, size};
    t.reversed = t.number(0, 1) == 'M';
    t.big = t.number(2, 2) == 43;
    const std::map<uint64_t, Entry> entries = readDirectory(t);
    if (!t.ok || !entries.contains(kWidth) || !entries.contains(kHeight))
        return refuse("is truncated or has a damaged header");
    const ImageHead head{"tif", int64_t(std::min<uint64_t>(first(t, entries, kWidth, 0), 1u << 31)),
                         int64_t(std::min<uint64_t>(first(t, entries, kHeight, 0), 1u << 31)), noDataOf(t, entries)};
    const bool withinLimits =
        head.width >= 1 && head.height >= 1 && head.width <= kMaxMapSide && head.height <= kMaxMapSide;
    const uint64_t bits =
        std::min<uint64_t>(first(t, entries, kBits, 1), 64) * std::min<uint64_t>(first(t, entries, kSamples, 1), 64);
    const uint64_t texels = uint64_t(head.width) * uint64_t(head.height);
    // What is too large is refused for that, by the caller.
    if (withinLimits && texels * bits / 8 <= kMaxMapBytes && !piecesFit(t, entries, bits, texels))
        return refuse("is truncated");
    return head;
}

}  // namespace sward
