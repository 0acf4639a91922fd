// Index: what a file holds, in the order of its bytes · reading · the cache folder.
#include <cstring>

#include "core/cache_file.h"
#include "core/hash.h"
#include "forest/volume_images.h"

namespace sward {
namespace {

constexpr char kMagic[8] = {'S', 'W', 'F', 'O', 'R', 'E', 'S', 'T'};
constexpr uint64_t kFileVersion = 3;
constexpr uint64_t kFileLimit = uint64_t(2) << 30;
constexpr uint64_t kMostItems = uint64_t(1) << 31;  // of a list

struct Writer {
    std::string bytes;
    template <class T>
    void value(const T& v) {
        bytes.append(reinterpret_cast<const char*>(&v), sizeof v);
    }
    template <class T>
    void list(const std::vector<T>& v) {
        value(static_cast<uint64_t>(v.size()));
        if (!v.empty()) bytes.append(reinterpret_cast<const char*>(v.data()), v.size() * sizeof(T));
    }
    // Lists of what is no plain data: their length, and each by its own.
    template <class T, class F>
    void each(const std::vector<T>& v, F write) {
        value(static_cast<uint64_t>(v.size()));
        for (const T& item : v) write(item);
    }
};
struct Reader {
    std::string_view left;
    bool sound = true;
    template <class T>
    void value(T& v) {
        if (left.size() < sizeof v) return fail();
        std::memcpy(&v, left.data(), sizeof v);
        left.remove_prefix(sizeof v);
    }
    template <class T>
    void list(std::vector<T>& v) {
        uint64_t n = 0;
        value(n);
        if (n > kMostItems || n * sizeof(T) > left.size()) return fail();
        v.resize(static_cast<size_t>(n));
        if (n > 0) std::memcpy(v.data(), left.data(), v.size() * sizeof(T));
        left.remove_prefix(v.size() * sizeof(T));
    }
    template <class T, class F>
    void each(std::vector<T>& v, F read) {
        uint64_t n = 0;
        value(n);
        if (n > left.size()) return fail();
        v.resize(static_cast<size_t>(n));
        for (T& item : v)
            if (sound) read(item);
    }
    void fail() { sound = false, left = {}; }
};

// One description for both ways: what is written is what is read.
template <class Io, class Images>
void describe(Io& io, Images& v) {
    io.value(v.side), io.value(v.layers), io.value(v.cells), io.value(v.edge), io.value(v.height);
    io.value(v.compressed);
    io.each(v.levels, [&](auto& level) { io.each(level, [&](auto& mip) { io.list(mip); }); });
    io.list(v.slots);
    io.value(v.air.side), io.value(v.air.layers), io.value(v.air.edge), io.value(v.air.height), io.value(v.air.cells);
    io.list(v.air.extinction), io.value(v.air.facing), io.list(v.air.owners), io.list(v.air.deeper),
        io.value(v.air.litSeen);
    for (auto& half : v.sky) io.list(half);
    io.each(v.trees, [&](auto& t) {
        io.value(t.side), io.value(t.layers), io.value(t.part), io.value(t.height), io.list(t.extinction);
        io.value(t.facing), io.value(t.litFacing);
    });
}

std::optional<VolumeImages> parse(const std::string& bytes, uint64_t key, std::string& wrong) {
    constexpr size_t kHead = sizeof(kMagic) + 16, kSum = 8;
    if (bytes.size() < kHead + kSum) return wrong = "it is truncated", std::nullopt;
    uint64_t head[2], sum;
    std::memcpy(head, bytes.data() + sizeof(kMagic), 16);
    std::memcpy(&sum, bytes.data() + bytes.size() - kSum, kSum);
    if (std::memcmp(bytes.data(), kMagic, sizeof(kMagic)) == 0 && head[0] != kFileVersion)
        return wrong = fmt::format("it is of version {}, not {}", head[0], kFileVersion), std::nullopt;
    if (std::memcmp(bytes.data(), kMagic, sizeof(kMagic)) != 0 || head[1] != key ||
        sum != hashBytes(bytes.data(), bytes.size() - kSum))
        return wrong = "it is damaged or truncated", std::nullopt;
    VolumeImages out;
    Reader in{std::string_view(bytes).substr(kHead, bytes.size() - kHead - kSum)};
    describe(in, out);
    if (!in.sound || !in.left.empty()) return wrong = "its size is not what it says", std::nullopt;
    return out;
}

}  // namespace

std::filesystem::path volumeFile(const std::filesystem::path& folder, uint64_t key) {
    return folder / "forests" / (hashHex(key) + ".forest");
}

std::optional<VolumeImages> loadCachedVolume(const std::filesystem::path& folder, uint64_t key) {
    return loadCached(volumeFile(folder, key), kFileLimit, "forest",
                      [&](const std::string& bytes, std::string& wrong) { return parse(bytes, key, wrong); });
}

void cacheVolume(const std::filesystem::path& folder, uint64_t key, const VolumeImages& images) {
    Writer out;
    out.bytes.append(kMagic, sizeof(kMagic));
    out.value(kFileVersion), out.value(key);
    describe(out, images);
    out.value(hashBytes(out.bytes.data(), out.bytes.size()));
    writeCached(volumeFile(folder, key), "forest", out.bytes);
}

}  // namespace sward
