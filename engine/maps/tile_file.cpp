#include "maps/tile_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <bit>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <unordered_map>
#include <unordered_set>

#include "core/file.h"
#include "core/hash.h"
#include "core/jobs.h"
#include "core/log.h"
#include "maps/map_io.h"

namespace fs = std::filesystem;

namespace sward {
namespace {

constexpr uint32_t kTiffHeadBytes = 8;  // of a TIFF: its kind, and where its directory begins
constexpr uint64_t kDirectoryAt = 4;

Error cannotBeRead(const fs::path& file) {
    return unsound("is damaged, or was cut short: some of its texels cannot be read",
                   "take it from a copy, or undo what another program did to it")
        .at(file);
}

class FileTexels final : public TexelSource {
  public:
    FileTexels(fs::path file, uint64_t directory)
        : file_(std::move(file)), fd_(::open(file_.c_str(), O_RDONLY | O_CLOEXEC)), directory_(directory) {
        if (fd_ >= 0 && ::fstat(fd_, &opened_) == 0) saidThen_ = hashOfDirectory();
    }
    ~FileTexels() override {
        if (fd_ >= 0) ::close(fd_);
    }
    bool opened() const { return fd_ >= 0; }
    // Nobody wrote to it since, or it has grown, which leaves what was there.
    Status sound() const override {
        if (failed_) return cannotBeRead(file_);
        struct stat now {};
        const bool same = ::fstat(fd_, &now) == 0 && now.st_mtim.tv_sec == opened_.st_mtim.tv_sec &&
                          now.st_mtim.tv_nsec == opened_.st_mtim.tv_nsec;
        if (same || (now.st_size > opened_.st_size && hashOfDirectory() == saidThen_)) return {};
        return unsound("was written over by another program since it was opened, and held what was not painted since",
                       "take it from a copy, or open the project anew with what the file holds now")
            .at(file_);
    }

    void read(uint64_t place, std::span<std::byte> out) const override {
        while (!out.empty()) {
            const ssize_t n = ::pread(fd_, out.data(), out.size(), static_cast<off_t>(place));
            if (n < 0 && errno == EINTR) continue;
            if (n <= 0) break;
            out = out.subspan(static_cast<size_t>(n)), place += static_cast<uint64_t>(n);
        }
        if (out.empty()) return;
        std::memset(out.data(), 0, out.size());
        if (!failed_.exchange(true)) logWarning(cannotBeRead(file_).text());
    }

  private:
    // Of the beginning of what refers to the tiles.
    uint64_t hashOfDirectory() const {
        char bytes[256] = {};
        const ssize_t n = ::pread(fd_, bytes, sizeof bytes, static_cast<off_t>(directory_));
        return n > 0 ? hashBytes(bytes, std::min(sizeof bytes, size_t(opened_.st_size) - directory_)) : 0;
    }
    fs::path file_;
    int fd_;
    uint64_t directory_, saidThen_ = 0;
    struct stat opened_ {};
    mutable std::atomic<bool> failed_{false};
};

// --- a directory --------------------------------------------------------------------------------------------------
// In this machine's order of bytes, as the texels are.
template <class T>
void put(std::string& out, T value) {
    out.append(reinterpret_cast<const char*>(&value), sizeof value);
}

enum FieldType : uint16_t { kShort = 3, kLong = 4 };
// An entry of one or two short numbers, or of a long one: its own, or where its values lie.
void putShorts(std::string& out, uint16_t tag, uint32_t count, uint16_t value, uint16_t second = 0) {
    put(out, tag), put(out, uint16_t(kShort)), put(out, count), put(out, value), put(out, second);
}
void putLong(std::string& out, uint16_t tag, uint16_t type, uint32_t count, uint32_t value) {
    put(out, tag), put(out, type), put(out, count), put(out, value);
}
// As many values as the map has channels: in the entry itself where two fit, else at `at`.
void putEach(std::string& out, uint16_t tag, int channels, uint16_t value, uint32_t at) {
    const auto count = static_cast<uint32_t>(channels);
    if (channels <= 2)
        putShorts(out, tag, count, value, channels == 2 ? value : uint16_t(0));
    else
        putLong(out, tag, kShort, count, at);
}

// What lies at the end of a file: values of its tiles, then the directory that refers to them.
struct End {
    std::string bytes;
    uint32_t directory = 0;  // where that begins
};
// begin: where the end is to lie, at an even place. Tags: TIFF 6.0 (Adobe 1992), sections 8 and 15.
End endOf(const MapInfo& info, const std::vector<uint32_t>& places, uint32_t tileBytes, uint32_t begin) {
    End end;
    std::string& out = end.bytes;
    const auto here = [&] { return begin + static_cast<uint32_t>(out.size()); };
    const uint32_t placesAt = here();
    for (const uint32_t place : places) put(out, place);
    const uint32_t sizesAt = here();
    for (size_t i = 0; i < places.size(); ++i) put(out, tileBytes);
    const uint32_t bitsAt = here();
    const auto bits = static_cast<uint16_t>(8 * pixelBytes(info.type));
    for (int c = 0; c < 4; ++c) put(out, bits);
    const uint32_t formatsAt = here();
    for (int c = 0; c < 4; ++c) put(out, uint16_t(1));
    end.directory = here();
    const auto count = static_cast<uint32_t>(places.size());
    const bool extra = info.channels == 2 || info.channels == 4;
    put(out, static_cast<uint16_t>(extra ? 13 : 12));
    putLong(out, 256, kLong, 1, static_cast<uint32_t>(info.width));
    putLong(out, 257, kLong, 1, static_cast<uint32_t>(info.height));
    putEach(out, 258, info.channels, bits, bitsAt);
    putShorts(out, 259, 1, 1);  // not compressed
    putShorts(out, 262, 1, info.channels < 3 ? 1 : 2);
    putShorts(out, 277, 1, static_cast<uint16_t>(info.channels));
    putShorts(out, 284, 1, 1);  // channels interleaved
    putShorts(out, 322, 1, kTileSize);
    putShorts(out, 323, 1, kTileSize);
    putLong(out, 324, kLong, count, count == 1 ? places[0] : placesAt);
    putLong(out, 325, kLong, count, count == 1 ? tileBytes : sizesAt);
    if (extra) putShorts(out, 338, 1, info.channels == 4 ? 2 : 0);  // opacity that is not multiplied in, or no colour
    putEach(out, 339, info.channels, 1, formatsAt);
    put(out, uint32_t(0));  // no directory after it
    return end;
}

std::string headOf(uint32_t directory) {
    std::string head = std::endian::native == std::endian::little ? "II" : "MM";
    put(head, uint16_t(42)), put(head, directory);
    return head;
}

std::string_view textOf(const TileTexels& t) { return {reinterpret_cast<const char*>(t.data()), t.size()}; }

bool differs(const Map& a, const Map& b, int tx, int ty) {
    return a.tile(tx, ty) != b.tile(tx, ty) && !sameTexels(*a.tile(tx, ty), *b.tile(tx, ty));
}

}  // namespace

bool keptInTiles(const MapInfo& info) {
    return info.type != PixelType::F32 && size_t(info.width) * size_t(info.height) > kHeldTexels;
}

Result<Map> openTiles(const fs::path& file, const PlainTiles& tiles) {
    const auto source = std::make_shared<FileTexels>(file, tiles.directory);
    if (!source->opened()) return unsound("cannot be read", "check who may read it").at(file);
    Map map(tiles.info);
    std::unordered_map<uint64_t, std::shared_ptr<const Tile>> made;
    for (size_t i = 0; i < tiles.places.size(); ++i) {
        std::shared_ptr<const Tile>& tile = made[tiles.places[i]];
        if (!tile) tile = std::make_shared<Tile>(source, tiles.places[i], map.tileBytes());
        map.setTile(static_cast<int>(i) % map.tilesX(), static_cast<int>(i) / map.tilesX(), tile);
    }
    return map;
}

Status tilesSound(const Map& map) {
    std::unordered_set<const TexelSource*> asked;
    for (int ty = 0; ty < map.tilesY(); ++ty)
        for (int tx = 0; tx < map.tilesX(); ++tx) {
            const Tile& tile = *map.tile(tx, ty);
            if (tile.source() && !asked.insert(tile.source().get()).second) continue;
            if (Status s = tile.sound(); !s) return s;
        }
    return {};
}

Status checkTiles(const Map& map) {
    parallelFor(size_t(map.tilesY()), [&](size_t ty) {
        for (int tx = 0; tx < map.tilesX(); ++tx)
            if (map.tile(tx, int(ty))->source()) map.tile(tx, int(ty))->look();
    });
    return tilesSound(map);
}

Status writeTiles(const fs::path& file, const Map& map) {
    CHECK(map.info().type != PixelType::F32);
    errno = 0;
    std::ofstream out(file, std::ios::binary | std::ios::trunc);
    const auto failure = [&] { return fileError("cannot be written", file, errno ? errno : EIO); };
    std::vector<uint32_t> places;
    std::unordered_map<const Tile*, uint32_t> written;
    out << headOf(0);
    auto size = kTiffHeadBytes;
    for (int ty = 0; ty < map.tilesY() && out; ++ty)
        for (int tx = 0; tx < map.tilesX(); ++tx) {
            const auto [place, fresh] = written.emplace(map.tile(tx, ty).get(), size);
            places.push_back(place->second);
            if (!fresh) continue;
            out << textOf(map.tile(tx, ty)->texels());
            size += static_cast<uint32_t>(map.tileBytes());
        }
    const End end = endOf(map.info(), places, static_cast<uint32_t>(map.tileBytes()), size);
    out << end.bytes;
    out.seekp(0);
    out << headOf(end.directory);
    out.close();
    if (!out) return failure();
    if (Status s = tilesSound(map); !s) return failed(s.error().message, s.error().remedy).at(s.error().file);
    return syncPath(file);
}

std::optional<PlainTiles> tilesOf(const fs::path& file, const MapInfo& info) {
    Result<ImageHead> head = readImageHead(file);
    if (!head || !head->tiles || !(head->tiles->info == info)) return {};
    return std::move(head->tiles);
}

bool worthGrowing(const fs::path& file, const Map& before, const Map& now) {
    if (!keptInTiles(now.info()) || !(before.info() == now.info()) || !mayGrow(file)) return false;
    const uint64_t whole = uint64_t(now.tilesX()) * uint64_t(now.tilesY()) * now.tileBytes();
    uint64_t size = stampOf(file).bytes;
    for (int ty = 0; ty < now.tilesY(); ++ty)
        for (int tx = 0; tx < now.tilesX(); ++tx)
            if (before.tile(tx, ty) != now.tile(tx, ty)) size += now.tileBytes();
    return size <= 2 * whole && tilesOf(file, now.info()).has_value();
}

Result<HeadSwitch> growTiles(FileGrowth& file, const PlainTiles& tiles, const Map& before, const Map& now) {
    const auto begin = [&] { return static_cast<uint32_t>(file.size()); };
    if (file.size() % 2 != 0)
        if (Status s = file.append(std::string_view("\0", 1)); !s) return s.error();
    std::vector<uint32_t> places;
    for (int ty = 0; ty < now.tilesY(); ++ty)
        for (int tx = 0; tx < now.tilesX(); ++tx) {
            const bool changed = differs(before, now, tx, ty);
            places.push_back(changed ? begin() : static_cast<uint32_t>(tiles.places[places.size()]));
            if (!changed) continue;
            if (Status s = file.append(textOf(now.tile(tx, ty)->texels())); !s) return s.error();
        }
    if (Status s = tilesSound(now); !s) return failed(s.error().message, s.error().remedy).at(s.error().file);
    const End end = endOf(now.info(), places, static_cast<uint32_t>(now.tileBytes()), begin());
    if (Status s = file.append(end.bytes); !s) return s.error();
    return HeadSwitch{kDirectoryAt, static_cast<uint32_t>(tiles.directory), end.directory, file.size()};
}

}  // namespace sward
