#include "reference/reference_part.h"

#include <cstring>
#include <fstream>

#include "core/file.h"
#include "core/hash.h"
#include "core/json.h"

namespace sward {
namespace {

constexpr const char* kKind = "sward reference part";
constexpr size_t kFloats = 7;  // a pixel: color, error, grass
constexpr uint64_t kMostBytes = uint64_t(8) << 30;

// Calls row(first pixel, pixels) for each row of the part's own.
template <class F>
void eachRow(const ReferenceSettings& s, F row) {
    for (int y = 0; y < s.height; ++y)
        if (isOfShard(y, s)) row(static_cast<size_t>(y) * static_cast<size_t>(s.width), static_cast<size_t>(s.width));
}
size_t rowsOf(const ReferenceSettings& s) {
    size_t n = 0;
    eachRow(s, [&](size_t, size_t) { ++n; });
    return n;
}

Error broken(const std::filesystem::path& file, const std::string& what) {
    return unsound(what, "make it again with sward reference --shard I/N").at(file);
}

std::optional<int> numberIn(const Json& j, const char* key, int least, int most) {
    const auto at = j.object.find(key);
    if (at == j.object.end() || at->second.type != Json::Type::Number) return std::nullopt;
    const double v = at->second.number;
    if (!(v >= least && v <= most) || v != std::floor(v)) return std::nullopt;
    return static_cast<int>(v);
}

std::string lineOf(const Json& head) {
    std::string line = writeJson(head);
    std::replace(line.begin(), line.end(), '\n', ' ');
    return line + '\n';
}

// What the part is one of, and the hash of that and of its pixels.
std::string firstLineOf(const ReferencePart& p, std::string_view pixels) {
    const ReferenceSettings& s = p.settings;
    Json head;
    head["kind"] = kKind, head["camera"] = p.camera, head["of"] = hashHex(p.of);
    head["width"] = s.width, head["height"] = s.height, head["samples"] = s.samples, head["shard"] = s.shard,
    head["shards"] = s.shards, head["band"] = s.bandRows;
    const std::string unhashed = lineOf(head);
    Hasher hash;
    hash.add(unhashed.data(), unhashed.size());
    hash.add(pixels.data(), pixels.size());
    head["hash"] = hashHex(hash.value());
    return lineOf(head);
}

}  // namespace

std::string encodePart(const ReferencePart& p) {
    std::string pixels;
    const auto add = [&](const std::vector<float>& from, size_t first, size_t n, size_t channels) {
        pixels.append(reinterpret_cast<const char*>(&from[first * channels]), n * channels * sizeof(float));
    };
    eachRow(p.settings, [&](size_t first, size_t n) {
        add(p.truth.color, first, n, 3), add(p.truth.error, first, n, 3), add(p.truth.grass, first, n, 1);
    });
    return firstLineOf(p, pixels) + pixels;
}

bool isReferencePart(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::string line;
    line.resize(4096);
    in.read(line.data(), static_cast<std::streamsize>(line.size()));
    line.resize(static_cast<size_t>(in.gcount()));
    return line.substr(0, line.find('\n')).find(kKind) != std::string::npos;
}

Result<ReferencePart> readPart(const std::filesystem::path& file) {
    const auto bytes = readFile(file, kMostBytes);
    if (!bytes) return bytes.error();
    const size_t end = bytes->find('\n');
    if (!isReferencePart(file) || end == std::string::npos) return broken(file, "this is no part of a reference");
    const auto head = parseJson(std::string_view(*bytes).substr(0, end), file.string());
    if (!head) return head.error();
    ReferencePart p;
    ReferenceSettings& s = p.settings;
    const auto width = numberIn(*head, "width", 1, 16384), height = numberIn(*head, "height", 1, 16384),
               samples = numberIn(*head, "samples", 1, kMaxReferenceSamples);
    const auto shards = numberIn(*head, "shards", 1, 1 << 20),
               shard = numberIn(*head, "shard", 0, shards.value_or(0) - 1),
               band = numberIn(*head, "band", 1, kShardRows);
    if (!width || !height || int64_t(*width) * *height > kMaxReferencePixels || !samples || !shards || !shard ||
        !band || !head->object.contains("of") || !head->object.contains("camera"))
        return broken(file, "the part's first line does not say what it is a part of");
    s.width = *width, s.height = *height, s.samples = *samples, s.shard = *shard, s.shards = *shards,
    s.bandRows = *band;
    p.camera = head->object.at("camera").text;
    p.of = std::strtoull(head->object.at("of").text.c_str(), nullptr, 16);
    const size_t pixels = static_cast<size_t>(s.width) * static_cast<size_t>(s.height),
                 wanted = rowsOf(s) * static_cast<size_t>(s.width) * kFloats * sizeof(float);
    if (bytes->size() - end - 1 != wanted)
        return broken(file, fmt::format("the part is damaged: {} bytes of pixels instead of {}",
                                        bytes->size() - end - 1, wanted));
    const std::string_view all(*bytes);
    if (all.substr(0, end + 1) != firstLineOf(p, all.substr(end + 1)))
        return broken(file, "the part is damaged: its bytes do not have the hash that its first line names");
    p.truth = {s.width, s.height, std::vector<float>(3 * pixels), std::vector<float>(3 * pixels),
               std::vector<float>(pixels)};
    const char* at = bytes->data() + end + 1;
    const auto take = [&](std::vector<float>& to, size_t first, size_t n, size_t channels) {
        std::memcpy(&to[first * channels], at, n * channels * sizeof(float));
        at += n * channels * sizeof(float);
    };
    eachRow(s, [&](size_t first, size_t n) {
        take(p.truth.color, first, n, 3), take(p.truth.error, first, n, 3), take(p.truth.grass, first, n, 1);
    });
    return p;
}

Result<Truth> mergeParts(const std::vector<std::filesystem::path>& files) {
    if (files.empty()) return failed("there are no parts", "name every part");
    std::vector<std::string> from;
    Truth whole;
    uint64_t of = 0;
    int band = 0;
    for (const auto& file : files) {
        auto part = readPart(file);
        if (!part) return part.error();
        const ReferenceSettings& s = part->settings;
        const size_t shard = static_cast<size_t>(s.shard);
        if (from.empty()) {
            from.resize(static_cast<size_t>(s.shards));
            whole = part->truth, of = part->of, band = s.bandRows;
        }
        if (part->of != of || from.size() != static_cast<size_t>(s.shards) || s.bandRows != band)
            return failed("this part is of another image than " + files[0].string(),
                          "project, camera, size, samples, seed, lighting and the number of shards must be the same")
                .at(file.string());
        if (!from[shard].empty())
            return failed(fmt::format("shard {} is there twice, in {} too", shard, from[shard]), "name each part once")
                .at(file.string());
        from[shard] = file.string();
        eachRow(s, [&](size_t first, size_t n) {
            std::copy_n(&part->truth.color[3 * first], 3 * n, &whole.color[3 * first]);
            std::copy_n(&part->truth.error[3 * first], 3 * n, &whole.error[3 * first]);
            std::copy_n(&part->truth.grass[first], n, &whole.grass[first]);
        });
    }
    for (size_t i = 0; i < from.size(); ++i)
        if (from[i].empty())
            return failed(fmt::format("shard {} of {} is missing", i, from.size()),
                          fmt::format("make it with sward reference --shard {}/{}", i, from.size()));
    return whole;
}

}  // namespace sward
