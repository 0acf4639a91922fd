// Index: reading images · R16 · readMap · writing · images for people.
#include "maps/map_io.h"

#include <cmath>
#include <cstring>
#include <limits>

#include "core/file.h"
#include "core/json.h"
#include "maps/image_file.h"
#include "maps/map_repair.h"
#include "maps/tile_file.h"

namespace fs = std::filesystem;

namespace sward {
namespace {

constexpr float kNoTexel = std::numeric_limits<float>::quiet_NaN();

using ValueRange = std::optional<std::pair<double, double>>;

std::string extensionOf(const fs::path& file) {
    std::string ext = file.extension().string();
    for (char& c : ext) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return ext == ".tiff" ? ".tif" : ext;
}

// --- reading images ----------------------------------------------------------------------------------------------
Status checkWish(const fs::path& file, const MapInfo& info, const MapWish& wish) {
    const bool addsAlpha = wish.channels == 4 && info.channels == 3;
    if (wish.channels != 0 && info.channels != wish.channels && !addsAlpha)
        return unsound(
                   fmt::format("has {} channel{}, not {}", info.channels, info.channels == 1 ? "" : "s", wish.channels),
                   fmt::format("export it with {}", wish.channels == 1   ? "one channel (grey, without alpha)"
                                                    : wish.channels == 2 ? "two channels"
                                                                         : "red, green, blue and alpha"))
            .at(file);
    if (wish.isHeight && info.type == PixelType::U8)
        return unsound("holds heights of 8 bits, which make steps", "export 16 bits or floats").at(file);
    return {};
}

// Full scale in the last of four channels, behind three that were read.
void addAlpha(const std::vector<std::byte>& rgb, PixelType type, std::vector<std::byte>& rgba) {
    const size_t size = pixelBytes(type), n = rgb.size() / (3 * size);
    const float one = 1.0f;
    const uint32_t full = 0xffffffffu;
    for (size_t i = 0; i < n; ++i) {
        std::memcpy(rgba.data() + i * 4 * size, rgb.data() + i * 3 * size, 3 * size);
        std::memcpy(rgba.data() + (i * 4 + 3) * size, type == PixelType::F32 ? static_cast<const void*>(&one) : &full,
                    size);
    }
}

void writeFlipped(Map& map, int y0, int rows, const std::byte* in, bool flip) {
    if (!flip) return map.writeRows(y0, rows, in);
    const size_t rowBytes = size_t(map.info().width) * map.texelBytes();
    for (int i = 0; i < rows; ++i) map.writeRows(map.info().height - 1 - (y0 + i), 1, in + size_t(i) * rowBytes);
}

// noData: as ImageReader has it, if given.
Result<Map> readPixels(const fs::path& file, const MapWish& wish, std::optional<double>* noData = nullptr) {
    auto opened = ImageReader::open(file);
    if (!opened) return opened.error();
    ImageReader& reader = **opened;
    const MapInfo own = reader.info();
    if (noData) *noData = reader.noData();
    if (Status s = checkWish(file, own, wish); !s) return s.error();
    MapInfo info = own;
    if (wish.channels != 0) info.channels = wish.channels;
    if (Status s = checkMapLimits(file, info); !s) return s.error();
    Map map(info);
    std::vector<std::byte> band, widened;
    for (int y = 0; y < info.height; y += kTileSize) {
        const int n = std::min(kTileSize, info.height - y);
        band.resize(size_t(n) * size_t(own.width) * size_t(own.channels) * pixelBytes(own.type));
        if (Status s = reader.readRows(y, n, band.data()); !s) return s.error();
        if (own.channels != info.channels) {
            widened.resize(size_t(n) * size_t(info.width) * map.texelBytes());
            addAlpha(band, info.type, widened);
        }
        writeFlipped(map, y, n, own.channels != info.channels ? widened.data() : band.data(), wish.flip);
    }
    return map;
}

// The tiles of a file of a large map that a wish takes as they are.
std::optional<PlainTiles> tilesToOpen(const fs::path& file, const MapWish& wish) {
    if (!wish.mayStay || wish.flip || extensionOf(file) != ".tif") return {};
    Result<ImageHead> head = readImageHead(file, wish.directory);
    if (!head || !head->tiles) return {};
    const MapInfo& info = head->tiles->info;
    const bool asItIs = keptInTiles(info) && (!wish.type || *wish.type == info.type) &&
                        (wish.channels == 0 || wish.channels == info.channels);
    return asItIs ? std::move(head->tiles) : std::nullopt;
}

Result<Map> openLarge(const fs::path& file, const PlainTiles& tiles, const MapWish& wish) {
    if (Status s = checkWish(file, tiles.info, wish); !s) return s.error();
    if (Status s = checkMapLimits(file, tiles.info); !s) return s.error();
    return openTiles(file, tiles);
}

// --- R16 ---------------------------------------------------------------------------------------------------------
struct Sidecar {
    int width = 0, height = 0;
    ValueRange range;
};

fs::path sidecarOf(const fs::path& file) {
    fs::path beside = file;
    beside += ".json";
    std::error_code ignored;
    if (fs::exists(beside, ignored)) return beside;
    return fs::path(file).replace_extension(".json");
}

bool readSide(const Json& root, const char* key, int& out) {
    const Json* j = root.find(key);
    if (!j || !j->isNumber() || j->number != std::floor(j->number) || std::abs(j->number) > 1e9) return false;
    out = static_cast<int>(j->number);
    return true;
}

Result<Sidecar> readSidecar(const fs::path& r16) {
    const fs::path file = sidecarOf(r16);
    const std::string form = "it holds {\"width\": 512, \"height\": 512, \"range\": [0, 100]}";
    Result<Json> json = readJson(file);
    if (!json) {
        Error e = json.error();
        if (e.remedy.empty() || e.line == 0) e.remedy = "an R16 file needs its size in this file: " + form;
        return e;
    }
    Sidecar s;
    if (!readSide(*json, "width", s.width) || !readSide(*json, "height", s.height))
        return unsound("width and height must be whole numbers", form)
            .at(file, std::max(1, json->line), std::max(1, json->column));
    const Json* range = json->find("range");
    if (!range) return s;
    if (!range->isArray() || range->array.size() != 2 || !range->array[0].isNumber() || !range->array[1].isNumber())
        return unsound("range must be a list of two numbers", form).at(file, range->line, range->column);
    s.range = {range->array[0].number, range->array[1].number};
    return s;
}

Result<Map> readR16(const fs::path& file, const MapWish& wish, ValueRange& range) {
    if (wish.channels > 1)
        return unsound(fmt::format("has 1 channel, not {}", wish.channels), "use PNG, EXR or TIFF").at(file);
    const Result<Sidecar> side = readSidecar(file);
    if (!side) return side.error();
    if (Status s = checkLimits(file, side->width, side->height, 1, 2); !s) return s.error();
    const uint64_t expected = uint64_t(side->width) * uint64_t(side->height) * 2;
    const Result<std::string> bytes = readFile(file, kMaxMapBytes);
    if (!bytes) return bytes.error();
    if (bytes->size() != expected)
        return unsound(fmt::format("has {} bytes; {} x {} texels take {}", bytes->size(), side->width, side->height,
                                   expected),
                       bytes->size() < expected ? "it is truncated, or its sidecar gives another size"
                                                : "its sidecar gives another size")
            .at(file);
    if (side->range) range = side->range;
    Map map({side->width, side->height, 1, PixelType::U16});
    std::vector<uint16_t> row(size_t(side->width));
    for (int y = 0; y < side->height; ++y) {
        const auto* in = reinterpret_cast<const unsigned char*>(bytes->data()) + size_t(y) * row.size() * 2;
        for (size_t x = 0; x < row.size(); ++x) row[x] = static_cast<uint16_t>(in[2 * x] | in[2 * x + 1] << 8);
        writeFlipped(map, y, 1, reinterpret_cast<const std::byte*>(row.data()), wish.flip);
    }
    return map;
}

// Little-endian, whatever this machine is.
std::string r16Bytes(const Map& map, const std::function<void(int, int, void*)>& rows) {
    const MapInfo& info = map.info();
    std::string out(size_t(info.width) * size_t(info.height) * 2, '\0');
    std::vector<uint16_t> row(size_t(info.width));
    for (int y = 0; y < info.height; ++y) {
        rows(y, 1, row.data());
        auto* to = reinterpret_cast<unsigned char*>(out.data()) + size_t(y) * row.size() * 2;
        for (size_t x = 0; x < row.size(); ++x) {
            to[2 * x] = static_cast<unsigned char>(row[x] & 0xff);
            to[2 * x + 1] = static_cast<unsigned char>(row[x] >> 8);
        }
    }
    return out;
}

Status writeSidecar(const fs::path& r16, const MapInfo& info, const ValueRange& range) {
    Json j = Json::makeObject();
    j["width"] = Json(info.width);
    j["height"] = Json(info.height);
    const auto [low, high] = range.value_or(std::pair(0.0, 1.0));
    j["range"] = Json(Json::Array{Json(low), Json(high)});
    return writeFileAtomic(fs::path(r16).replace_extension(".json"), writeJson(j));
}

// --- readMap -----------------------------------------------------------------------------------------------------
// noData: how many of them the file says to have none.
void describeRepair(const TexelRepair& r, size_t noData, std::vector<std::string>& out) {
    const std::string place = fmt::format("texel ({}, {})", r.firstX, r.firstY);
    const std::string count = r.count == 1 ? place : fmt::format("{} and {} more", place, r.count - 1);
    const std::string verb = noData == 0         ? (r.count == 1 ? "is not finite" : "are not finite")
                             : noData == r.count ? (r.count == 1 ? "has no data" : "have no data")
                                                 : "are not finite or have no data";
    out.push_back(fmt::format("{} {}; replaced by {}", count, verb,
                              r.anyFinite ? "the nearest finite texel" : "0, for there is no finite texel"));
}

// Texels of that value, in the file's numbers, become NaN; returns their count. Integers become floats for it.
size_t markNoData(Map& map, double value) {
    const MapInfo info = map.info();
    const double full = info.type == PixelType::U8 ? 255 : info.type == PixelType::U16 ? 65535 : 1;
    const float wanted = static_cast<float>(value / full);
    Map marked = info.type == PixelType::F32 ? map : convertMap(map, PixelType::F32);
    size_t n = 0;
    for (int y = 0; y < info.height; ++y)
        for (int x = 0; x < info.width; ++x)
            for (int c = 0; c < info.channels; ++c)
                if (marked.at(x, y, c) == wanted) marked.set(x, y, c, kNoTexel), n += c == 0;
    if (n > 0) map = std::move(marked);
    return n;
}

struct Repaired {
    TexelRepair texels;
    size_t noData = 0;
};
// Gives every texel a value; the map keeps its type.
Repaired repair(Map& map, const std::optional<double>& noData) {
    const PixelType type = map.info().type;
    Repaired r;
    if (noData && std::isfinite(*noData)) r.noData = markNoData(map, *noData);
    r.texels = repairTexels(map);
    if (map.info().type != type) map = convertMap(map, type);
    return r;
}

// --- writing -----------------------------------------------------------------------------------------------------
// The map in a type that the format holds.
Result<Map> mapForFormat(const fs::path& file, const std::string& ext, const Map& map, const ValueRange& range) {
    const PixelType type = map.info().type;
    if (ext == ".exr") return convertMap(map, PixelType::F32, range);
    if (ext == ".tif") return map;
    if (ext != ".png" && ext != ".r16")
        return failed(fmt::format("\"{}\" is no format for maps", ext), "use .png, .exr, .tif or .r16").at(file);
    if (ext == ".r16" && map.info().channels != 1)
        return failed("R16 holds one channel", "use .png, .exr or .tif").at(file);
    if (type == PixelType::F32 && !range)
        return failed(fmt::format("{} holds integers, and the map has floats", ext == ".png" ? "PNG" : "R16"),
                      "use .exr or .tif, or say which range becomes 0 to full scale")
            .at(file);
    return type == PixelType::U8 && ext == ".png" ? map : convertMap(map, PixelType::U16, range);
}

std::function<void(int, int, void*)> rowsOf(const Map& map, bool flip) {
    return [&map, flip](int y0, int rows, void* out) {
        if (!flip) return map.readRows(y0, rows, out);
        const size_t rowBytes = size_t(map.info().width) * map.texelBytes();
        for (int i = 0; i < rows; ++i)
            map.readRows(map.info().height - 1 - (y0 + i), 1, static_cast<std::byte*>(out) + size_t(i) * rowBytes);
    };
}

Status writeInTiles(const fs::path& file, const Map& map) {
    const fs::path part = partPath(file);
    std::error_code fault;
    if (Status s = writeTiles(part, map); !s) {
        fs::remove(part, fault);
        Error e = s.error();
        if (e.file == part.string()) e.file = file.string();
        return e;
    }
    fs::rename(part, file, fault);
    if (fault) return fileError("cannot be written", file, fault.value());
    return syncPath(file.has_parent_path() ? file.parent_path() : fs::path("."));
}

Status writeBytes(const fs::path& file, const Result<std::string>& bytes) {
    if (bytes) return writeFileAtomic(file, *bytes);
    Error e = bytes.error();
    e.file = file.string();
    return e;
}

Status writePlain(const fs::path& file, const char* format, const MapInfo& info, const void* pixels) {
    const size_t rowBytes = size_t(info.width) * size_t(info.channels) * pixelBytes(info.type);
    const auto rows = [&](int y0, int n, void* out) {
        std::memcpy(out, static_cast<const std::byte*>(pixels) + size_t(y0) * rowBytes, size_t(n) * rowBytes);
    };
    return writeBytes(file, encodeImage(format, info, rows));
}

}  // namespace

Result<Map> readMap(const fs::path& file, const MapWish& wish, std::vector<std::string>* repaired) {
    if (const auto tiles = tilesToOpen(file, wish)) return openLarge(file, *tiles, wish);
    if (wish.directory)
        return unsound("lacks what an interrupted save had added to it",
                       "take it from a copy, or remove the folder .sward-save to open the project as it was before")
            .at(file);
    ValueRange range = wish.range;
    ValueRange stated;  // by an R16's sidecar
    std::optional<double> noData;
    Result<Map> map = extensionOf(file) == ".r16" ? readR16(file, wish, stated) : readPixels(file, wish, &noData);
    if (!map) return map;
    if (!range) range = stated;
    std::vector<std::string> said;
    if (map->info().width == 1 && map->info().height == 1)
        said.push_back("texel (0, 0) is the only one; the map is constant");
    if (const Repaired r = repair(*map, noData); r.texels.count > 0) describeRepair(r.texels, r.noData, said);
    if (repaired) repaired->insert(repaired->end(), said.begin(), said.end());
    return wish.type ? convertMap(*map, *wish.type, range) : std::move(*map);
}

ValueRange sidecarRange(const fs::path& file) {
    if (extensionOf(file) != ".r16") return {};
    const Result<Sidecar> side = readSidecar(file);
    return side ? side->range : std::nullopt;
}

Status writeMap(const fs::path& file, const Map& map, bool flip, const ValueRange& range) {
    CHECK(!map.empty());
    const std::string ext = extensionOf(file);
    const Result<Map> fitting = mapForFormat(file, ext, map, range);
    if (!fitting) return fitting.error();
    if (ext == ".tif" && keptInTiles(fitting->info()) && !flip) return writeInTiles(file, *fitting);
    const auto rows = rowsOf(*fitting, flip);
    const Result<std::string> bytes = ext == ".r16" ? Result<std::string>(r16Bytes(*fitting, rows))
                                                    : encodeImage(ext.substr(1), fitting->info(), rows);
    if (Status s = tilesSound(map); !s) return failed(s.error().message, s.error().remedy).at(s.error().file);
    if (ext != ".r16") return writeBytes(file, bytes);
    if (Status s = writeSidecar(file, fitting->info(), range); !s) return s;
    return writeFileAtomic(file, *bytes);
}

// --- images for people -------------------------------------------------------------------------------------------
Status writeImagePng(const fs::path& file, int width, int height, int channels, const std::vector<uint8_t>& pixels) {
    CHECK_EQ(pixels.size(), size_t(width) * size_t(height) * size_t(channels));
    return writePlain(file, "png", {width, height, channels, PixelType::U8}, pixels.data());
}

Status writeImageExr(const fs::path& file, int width, int height, int channels, const std::vector<float>& pixels) {
    CHECK_EQ(pixels.size(), size_t(width) * size_t(height) * size_t(channels));
    return writePlain(file, "exr", {width, height, channels, PixelType::F32}, pixels.data());
}

Result<Image> readImage(const fs::path& file, bool keepNonFinite) {
    MapWish wish;
    wish.channels = 0;
    Result<Map> map = readPixels(file, wish);
    if (!map) return map.error();
    Image image{map->info().width, map->info().height, map->info().channels, map->info().type == PixelType::F32, {}};
    const Map floats = convertMap(*map, PixelType::F32);
    image.pixels.resize(size_t(image.width) * size_t(image.height) * size_t(image.channels));
    floats.readRows(0, image.height, image.pixels.data());
    for (float& v : image.pixels)
        if (!keepNonFinite && !std::isfinite(v)) v = 0;
    return image;
}

Status checkMapLimits(const fs::path& file, const MapInfo& info) {
    return checkLimits(file, info.width, info.height, info.channels, pixelBytes(info.type));
}

Status checkImage(const fs::path& file) {
    const auto opened = ImageReader::open(file);
    if (!opened) return opened.error();
    const MapInfo& info = (*opened)->info();
    std::vector<std::byte> band(size_t(info.width) * size_t(info.channels) * pixelBytes(info.type) * kTileSize);
    for (int y = 0; y < info.height; y += kTileSize)
        if (Status s = (*opened)->readRows(y, std::min(kTileSize, info.height - y), band.data()); !s) return s;
    return {};
}

}  // namespace sward
