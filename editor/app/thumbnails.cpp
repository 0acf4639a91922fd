#include "app/thumbnails.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "core/file.h"
#include "core/hash.h"
#include "scene/components.h"

namespace fs = std::filesystem;

namespace sward {
namespace {

std::string endingOf(const fs::path& file) {
    std::string ending = file.extension().string();
    for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return ending;
}
bool isModel(const fs::path& file) { return endingOf(file) == ".glb" || endingOf(file) == ".gltf"; }
bool isImage(const fs::path& file) {
    const std::string ending = endingOf(file);
    return ending == ".png" || ending == ".exr" || ending == ".tif" || ending == ".tiff";
}

// A file that another took the place of is another one.
std::string keyOf(const fs::path& file) {
    const FileStamp s = stampOf(file);
    return fmt::format("{} {} {} {}", file.string(), s.number, s.bytes, s.changedNs);
}

// The one under this key, asked for now.
Thumbnail& asked(Thumbnails& t, const std::string& key) {
    Thumbnail& one = t.all[key];
    one.lastAsked = t.frame;
    return one;
}

void show(Thumbnail& one, Gpu& gpu, const Rgba8& image) {
    if (one.texture.width != image.width || one.texture.height != image.height)
        one.texture = makeTexture2D(gpu, "editor/thumbnails", GL_RGBA8, image.width, image.height);
    glTextureSubImage2D(one.texture.id(), 0, 0, 0, image.width, image.height, GL_RGBA, GL_UNSIGNED_BYTE,
                        image.pixels.data());
    one.made = true;
}

// The job's result, if there is one, to the picture that it is for.
bool take(Thumbnails& t, Gpu& gpu) {
    std::optional<Result<Rgba8>> made = t.job.take(0);
    if (!made) return false;
    const auto at = t.all.find(std::exchange(t.making, ""));
    if (at == t.all.end()) return false;
    if (*made)
        show(at->second, gpu, **made);
    else
        at->second.made = true, at->second.error = made->error().text();
    return true;
}

// Those that are in sight come first.
bool beginNext(Thumbnails& t) {
    auto next = t.all.end();
    for (auto it = t.all.begin(); it != t.all.end(); ++it)
        if (it->second.make && (next == t.all.end() || it->second.lastAsked > next->second.lastAsked)) next = it;
    if (next == t.all.end()) return false;
    t.making = next->first;
    t.job = Job<Rgba8>("a picture", 0, std::exchange(next->second.make, nullptr));
    return true;
}

bool showMaps(Thumbnails& t, Gpu& gpu) {
    bool changed = false;
    for (auto& [key, one] : t.all) {
        if (one.of.empty() || one.made) continue;
        show(one, gpu, portraitOfMap(one.of, one.kind));
        changed = true;
    }
    return changed;
}

// A map's tiles are let go as soon as it is not shown; others stay for a while.
void forget(Thumbnails& t) {
    std::erase_if(t.all, [&](const auto& one) { return !one.second.of.empty() && one.second.lastAsked + 2 < t.frame; });
    while (t.all.size() > kMostThumbnails) {
        const auto oldest = std::min_element(t.all.begin(), t.all.end(), [](const auto& a, const auto& b) {
            return a.second.lastAsked < b.second.lastAsked;
        });
        if (oldest->second.lastAsked + 2 >= t.frame) return;
        t.all.erase(oldest);
    }
}

}  // namespace

bool hasPicture(const fs::path& file) { return isModel(file) || isImage(file); }

const Thumbnail& fileThumbnail(Thumbnails& t, const fs::path& root, const std::string& file) {
    const fs::path whole = root / file;
    Thumbnail& one = asked(t, keyOf(whole));
    if (one.made || one.make || t.making == keyOf(whole)) return one;
    if (isModel(file) && t.tables)
        one.make = [root, file, tables = t.tables](JobControl& c) { return portraitOfModel(root, file, *tables, c); };
    else if (isImage(file))
        one.make = [whole](JobControl& c) { return portraitOfImage(whole, c); };
    else
        one.made = true;
    return one;
}

const Thumbnail& speciesThumbnail(Thumbnails& t, const Species& species, const fs::path& root) {
    if (!t.tables) return asked(t, "species");
    const std::string texture = species.texture.empty() ? "" : keyOf(root / species.texture);
    const std::string key = "species " + hashHex(portraitKey(species, *t.tables)) + texture;
    Thumbnail& one = asked(t, key);
    if (!one.made && !one.make && t.making != key)
        one.make = [species, root, tables = t.tables](JobControl& c) {
            return portraitOfSpecies(species, root, *tables, c);
        };
    return one;
}

const Thumbnail& mapThumbnail(Thumbnails& t, const std::string& path, const Map& map, MapKind kind) {
    Thumbnail& one = asked(t, "map " + path);
    if (!one.of.sameTiles(map)) one.of = map, one.kind = kind, one.made = false;
    return one;
}

ui::Shown shownOf(const Thumbnail& t) {
    return t.texture.id() ? ui::Shown{t.texture.id(), t.texture.width, t.texture.height} : ui::Shown{};
}

bool followThumbnails(Thumbnails& t, Gpu& gpu, bool wait) {
    ++t.frame;
    bool changed = showMaps(t, gpu);
    forget(t);
    do {
        while (wait && t.job.active() && !t.job.finished()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
        changed = take(t, gpu) || changed;
        if (!t.job.active()) beginNext(t);
    } while (wait && t.job.active());
    return changed;
}

bool makingThumbnails(const Thumbnails& t) { return t.job.active(); }

}  // namespace sward
