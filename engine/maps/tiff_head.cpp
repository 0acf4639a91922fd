// The directory of a TIFF or BigTIFF: its size, whether its strips or tiles lie within the file, and where they lie if
// they are texels as they are.
// Source: TIFF 6.0 (Adobe 1992), section 2; BigTIFF as libtiff reads it; GDAL's tag for what has no data (42113).
#include <algorithm>
#include <bit>
#include <cstdlib>
#include <map>

#include "core/file.h"
#include "maps/image_head.h"

namespace sward {
namespace {

constexpr uint64_t kMaxValues = 1 << 20;  // strips or tiles of one image; 16384 rows have fewer
enum Tag : uint16_t {
    kWidth = 256,
    kHeight = 257,
    kBits = 258,
    kCompression = 259,
    kPhotometric = 262,
    kFillOrder = 266,
    kStripOffsets = 273,
    kOrientation = 274,
    kSamples = 277,
    kStripBytes = 279,
    kPlanar = 284,
    kPredictor = 317,
    kTileWidth = 322,
    kTileHeight = 323,
    kTileOffsets = 324,
    kTileBytes = 325,
    kExtraSamples = 338,
    kSampleFormat = 339,
    kNoData = 42113  // a number as text
};

struct Tiff {
    std::istream& in;
    uint64_t size;
    bool big = false;       // 64-bit offsets
    bool reversed = false;  // big-endian
    bool ok = true;         // false once a read lay outside the file

    // `count` numbers of so many bytes, one after another.
    std::vector<uint64_t> numbers(uint64_t at, int bytes, uint64_t count) {
        in.clear();
        in.seekg(static_cast<std::streamoff>(at));
        if (at > size || (size - at) / uint64_t(bytes) < count) return ok = false, std::vector<uint64_t>();
        std::vector<unsigned char> b(size_t(count) * size_t(bytes));
        if (!in.read(reinterpret_cast<char*>(b.data()), std::streamsize(b.size()))) ok = false;
        std::vector<uint64_t> values(count);
        for (size_t k = 0; k < values.size(); ++k)
            for (int i = 0; i < bytes; ++i)
                values[k] = values[k] << 8 | b[k * size_t(bytes) + size_t(reversed ? i : bytes - 1 - i)];
        return values;
    }
    uint64_t number(uint64_t at, int bytes) {
        const std::vector<uint64_t> values = numbers(at, bytes, 1);
        return values.empty() ? 0 : values[0];
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

std::map<uint64_t, Entry> readDirectory(Tiff& t, uint64_t directory) {
    std::map<uint64_t, Entry> entries;
    const int offset = t.big ? 8 : 4, entrySize = t.big ? 20 : 12, countSize = t.big ? 8 : 2;
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

std::vector<uint64_t> valuesOf(Tiff& t, const Entry& e) { return t.numbers(e.values, e.bytes, e.count); }

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
    const std::vector<uint64_t> places = valuesOf(t, offsets->second), bytes = valuesOf(t, sizes->second);
    uint64_t total = 0;
    for (size_t i = 0; t.ok && i < bytes.size(); ++i) {
        if (places[i] > t.size || bytes[i] > t.size - places[i]) return false;
        total += bytes[i];
    }
    const bool plain = first(t, entries, kCompression, 1) == 1;
    return t.ok && (!plain || total >= texels * texelBits / 8);
}

// Whether every value of an entry is this one, as it is where the entry is absent.
bool all(Tiff& t, const std::map<uint64_t, Entry>& entries, Tag tag, uint64_t value) {
    const auto it = entries.find(tag);
    if (it == entries.end()) return true;
    if (it->second.count > kMaxValues) return false;
    const std::vector<uint64_t> values = valuesOf(t, it->second);
    return std::all_of(values.begin(), values.end(), [&](uint64_t v) { return v == value; });
}

// Nothing for all that the library is to read. The pieces fit.
std::optional<PlainTiles> plainTiles(Tiff& t, const std::map<uint64_t, Entry>& entries, const ImageHead& head) {
    const uint64_t bits = first(t, entries, kBits, 1), channels = first(t, entries, kSamples, 1);
    if (t.big || !entries.contains(kTileOffsets)) return {};
    const bool alike = all(t, entries, kBits, bits) && all(t, entries, kSampleFormat, 1);
    const bool asWritten = all(t, entries, kCompression, 1) && all(t, entries, kPlanar, 1) &&
                           all(t, entries, kPredictor, 1) && all(t, entries, kFillOrder, 1) &&
                           all(t, entries, kOrientation, 1) && t.reversed == (std::endian::native == std::endian::big);
    const bool inTiles =
        first(t, entries, kTileWidth, 0) == kTileSize && first(t, entries, kTileHeight, 0) == kTileSize;
    const uint64_t meaning = first(t, entries, kPhotometric, 0), alpha = first(t, entries, kExtraSamples, 0);
    const bool asMaps = meaning == (channels < 3 ? 1u : 2u) && alpha != 1;  // neither inverted nor multiplied in
    if (!alike || !asWritten || !inTiles || !asMaps || head.noData) return {};
    if ((bits != 8 && bits != 16) || channels < 1 || channels > 4) return {};
    PlainTiles tiles{{static_cast<int>(head.width), static_cast<int>(head.height), static_cast<int>(channels),
                      bits == 8 ? PixelType::U8 : PixelType::U16},
                     0,
                     valuesOf(t, entries.at(kTileOffsets))};
    const Map shape(tiles.info);
    const bool whole = tiles.places.size() == size_t(shape.tilesX()) * size_t(shape.tilesY()) &&
                       all(t, entries, kTileBytes, shape.tileBytes());
    return whole && t.ok ? std::optional(std::move(tiles)) : std::nullopt;
}

}  // namespace

Result<ImageHead> readTiffHead(const std::filesystem::path& file, std::istream& in, uint64_t size,
                               std::optional<uint64_t> directory) {
    const auto refuse = [&](const char* what) { return unsound(what, "export it again").at(file); };
    Tiff t{in, size};
    t.reversed = t.number(0, 1) == 'M';
    t.big = t.number(2, 2) == 43;
    const uint64_t begin = directory ? *directory : t.number(t.big ? 8 : 4, t.big ? 8 : 4);
    const std::map<uint64_t, Entry> entries = readDirectory(t, begin);
    if (!t.ok || !entries.contains(kWidth) || !entries.contains(kHeight))
        return refuse("is truncated or has a damaged header");
    ImageHead head{"tif",
                   int64_t(std::min<uint64_t>(first(t, entries, kWidth, 0), 1u << 31)),
                   int64_t(std::min<uint64_t>(first(t, entries, kHeight, 0), 1u << 31)),
                   noDataOf(t, entries),
                   {}};
    const bool withinLimits =
        head.width >= 1 && head.height >= 1 && head.width <= kMaxMapSide && head.height <= kMaxMapSide;
    const uint64_t bits =
        std::min<uint64_t>(first(t, entries, kBits, 1), 64) * std::min<uint64_t>(first(t, entries, kSamples, 1), 64);
    const uint64_t texels = uint64_t(head.width) * uint64_t(head.height);
    // What is too large is refused for that, by the caller.
    if (!withinLimits || texels * bits / 8 > kMaxMapBytes) return head;
    if (!piecesFit(t, entries, bits, texels)) return refuse("is truncated");
    head.tiles = plainTiles(t, entries, head);
    if (head.tiles) head.tiles->directory = begin;
    return head;
}

}  // namespace sward
