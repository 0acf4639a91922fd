// Pictures that panels show beside names, made one at a time beside the frames: a panel asks for one in each frame in
// which it shows it, and gets it once it is there. Headless frames wait, so that a screenshot has them all.
// Does not: take pictures (model/portrait.h), nor draw them (ui/tiles.h).
#pragma once
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>

#include "core/jobs.h"
#include "gpu/resources.h"
#include "model/portrait.h"
#include "ui/tiles.h"

namespace sward {

// What a panel shows of one.
struct Thumbnail {
    Texture texture;         // 0: not there, or there is none of it
    bool made = false;       // it was tried; without a texture then, why not:
    std::string error;       // in words
    uint64_t lastAsked = 0;  // frame, as Thumbnails counts them
    Map of;                  // of a painted map: what the texture shows, or is to show while it is not made
    MapKind kind = MapKind::Amounts;
    // How it is made; called once, from another thread.
    std::function<Result<Rgba8>(JobControl&)> make;
};

inline constexpr size_t kMostThumbnails = 400;  // beyond these the ones that were not shown for longest go

struct Thumbnails {
    std::map<std::string, Thumbnail> all;  // by what they show
    Job<Rgba8> job;
    std::string making;  // the key of the job's
    uint64_t frame = 1;
    const Tables* tables = nullptr;  // of the components; null: nothing that must be traced is made
};

// Of a file, by its ending an object or an image; empty for others. A file that changes is looked at anew. `file`:
// relative to `root`.
const Thumbnail& fileThumbnail(Thumbnails& t, const std::filesystem::path& root, const std::string& file);
// Whether fileThumbnail has a picture for files of this ending.
bool hasPicture(const std::filesystem::path& file);
// Of a species.
const Thumbnail& speciesThumbnail(Thumbnails& t, const Species& species, const std::filesystem::path& root);
// Of a painted map, which follows what is painted from frame to frame. `path`: its PATH.
const Thumbnail& mapThumbnail(Thumbnails& t, const std::string& path, const Map& map, MapKind kind);

// As ui/tiles.h draws it.
ui::Shown shownOf(const Thumbnail& thumbnail);

// Once a frame, before the widgets: takes what is finished, begins the next, forgets what is not shown. True if
// something new is to be seen. `wait`: makes all that was asked for.
bool followThumbnails(Thumbnails& t, Gpu& gpu, bool wait);
// One is being made.
bool makingThumbnails(const Thumbnails& t);

}  // namespace sward
