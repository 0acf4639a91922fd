#include "grass/slice_file.h"

#include <cstring>

#include "core/cache_file.h"
#include "core/hash.h"
#include "grass/slice_settings.h"

namespace sward {
namespace {

constexpr char kMagic[8] = {'S', 'W', 'S', 'L', 'I', 'C', 'E', 'S'};
constexpr uint32_t kVersion = 4;
constexpr uint64_t kFileLimit = uint64_t(1) << 30;

struct Head {
    char magic[8];
    uint32_t version;
    int32_t slices, width, height, farSize;
    float top, reflectScale;
    uint32_t pad = 0;
    uint64_t key;
};

using Channel = std::vector<uint8_t> SliceLevel::*;
constexpr Channel kChannels[] = {&SliceLevel::reflectance, &SliceLevel::threshold, &SliceLevel::front,
                                 &SliceLevel::back};

std::vector<SliceLevel> levelsOf(int width, int height, size_t layers) {
    std::vector<SliceLevel> out;
    for (int w = width, h = height;; w = std::max(w / 2, 1), h = std::max(h / 2, 1)) {
        SliceLevel l;
        l.width = w, l.height = h;
        for (const Channel c : kChannels) (l.*c).resize(4 * static_cast<size_t>(w) * h * layers);
        out.push_back(std::move(l));
        if (w == 1 && h == 1) return out;
    }
}

// Bytes of all that the levels of a head hold.
uint64_t bytesOf(const Head& h) {
    uint64_t texels = 0;
    const auto add = [&](int width, int height, uint64_t layers) {
        for (int w = width, y = height;; w = std::max(w / 2, 1), y = std::max(y / 2, 1)) {
            texels += layers * static_cast<uint64_t>(w) * static_cast<uint64_t>(y);
            if (w == 1 && y == 1) return;
        }
    };
    add(h.width, h.height, 2 * static_cast<uint64_t>(h.slices)), add(h.farSize, h.farSize, 1);
    return texels * 4 * std::size(kChannels);
}

bool soundHead(const Head& h, uint64_t key) {
    const auto size = [](int v) { return v >= 1 && v <= 2048 && (v & (v - 1)) == 0; };
    return std::memcmp(h.magic, kMagic, 8) == 0 && h.key == key && h.slices >= 1 && h.slices <= kMaxSlices &&
           size(h.width) && size(h.height) && size(h.farSize);
}

std::optional<SliceImages> parse(const std::string& bytes, uint64_t key, std::string& wrong) {
    Head h;
    if (bytes.size() < sizeof(h) + 8) return wrong = "it is truncated", std::nullopt;
    std::memcpy(&h, bytes.data(), sizeof(h));
    if (std::memcmp(h.magic, kMagic, 8) == 0 && h.version != kVersion)
        return wrong = fmt::format("it is of version {}, not {}", h.version, kVersion), std::nullopt;
    uint64_t sum;
    std::memcpy(&sum, bytes.data() + bytes.size() - 8, 8);
    if (!soundHead(h, key) || sum != hashBytes(bytes.data(), bytes.size() - 8))
        return wrong = "it is damaged or truncated", std::nullopt;
    if (bytes.size() != sizeof(h) + bytesOf(h) + 8) return wrong = "its size is not what its head says", std::nullopt;
    SliceImages out;
    out.slices = h.slices, out.top = h.top, out.reflectScale = h.reflectScale;
    out.vertical = levelsOf(h.width, h.height, 2 * static_cast<size_t>(h.slices));
    out.far = levelsOf(h.farSize, h.farSize, 1);
    const char* from = bytes.data() + sizeof(h);
    for (auto* levels : {&out.vertical, &out.far})
        for (SliceLevel& l : *levels)
            for (const Channel c : kChannels) {
                std::memcpy((l.*c).data(), from, (l.*c).size());
                from += (l.*c).size();
            }
    return out;
}

}  // namespace

std::filesystem::path sliceFile(const std::filesystem::path& folder, uint64_t key) {
    return folder / "slices" / (hashHex(key) + ".slices");
}

std::optional<SliceImages> loadCachedSlices(const std::filesystem::path& folder, uint64_t key) {
    return loadCached(sliceFile(folder, key), kFileLimit, "slices",
                      [&](const std::string& bytes, std::string& wrong) { return parse(bytes, key, wrong); });
}

void cacheSlices(const std::filesystem::path& folder, uint64_t key, const SliceImages& images) {
    Head h{};
    std::memcpy(h.magic, kMagic, 8);
    h.version = kVersion, h.key = key;
    h.slices = images.slices, h.width = images.vertical[0].width, h.height = images.vertical[0].height,
    h.farSize = images.far[0].width;
    h.top = images.top, h.reflectScale = images.reflectScale;
    std::string bytes(reinterpret_cast<const char*>(&h), sizeof(h));
    for (const auto* levels : {&images.vertical, &images.far})
        for (const SliceLevel& l : *levels)
            for (const Channel c : kChannels) bytes.append(reinterpret_cast<const char*>((l.*c).data()), (l.*c).size());
    const uint64_t sum = hashBytes(bytes.data(), bytes.size());
    bytes.append(reinterpret_cast<const char*>(&sum), 8);
    writeCached(sliceFile(folder, key), "slices", bytes);
}

}  // namespace sward
