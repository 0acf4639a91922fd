// Draws the pictures of a FilmPlan beside the editor's frames: on a snapshot, with a renderer of its own, a strip of a
// picture at a time, so that menus answer meanwhile. A strip costs the more the more cells it shares with the next.
// Does not: ask for the plan (panels/film_dialog.cpp). Memory: the renderer's, and 12 bytes a pixel.
#pragma once
#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "frame/renderer.h"
#include "model/document.h"
#include "model/film_plan.h"

namespace sward {

struct Film {
    FilmPlan plan;
    Project project;  // as it was when it began
    ViewCamera view;
    ViewMode mode = ViewMode::Final;
    std::unique_ptr<Renderer> renderer;
    int frames = 1, done = 0;     // pictures
    int row = 0, rows = 0;        // of the present picture: pixels from its top that are there; of the next strip
    std::vector<uint8_t> pixels;  // of a .png ...
    std::vector<float> linear;    // ... and of an .exr
    std::chrono::steady_clock::time_point begun;
};

// Starts it; errors as checkFilm. The folder of a film is made.
Result<std::unique_ptr<Film>> startFilm(const Document& document, Gpu& gpu, const FilmPlan& plan,
                                        const ViewCamera& view, ViewMode mode);
// Draws strips for about `ms`, at least one; whole pictures are written. Nothing while there is more to do; then how
// it ended. What was written before a failure stays.
std::optional<Status> pumpFilm(Film& film, double ms);
// Share of all its pixels that are there.
double shareOf(const Film& film);
// From its first strip to its last, without a break: for scripts.
Status makeFilm(const Document& document, Gpu& gpu, const FilmPlan& plan, const ViewCamera& view, ViewMode mode);
struct ScriptHost;
// Scripts of the host may draw pictures and films; `gpu` is asked at each call.
void offerFilms(ScriptHost& host, std::function<Result<Gpu*>()> gpu);

}  // namespace sward
