#include "app/film.h"

#include <algorithm>
#include <cmath>

#include "core/file.h"
#include "maps/map_io.h"
#include "script/script.h"

namespace sward {
namespace {

constexpr double kStripMs = 25;  // what a strip should cost
constexpr int kLeastRows = 16;

using Clock = std::chrono::steady_clock;
double msSince(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

bool isLinear(const Film& f) { return fileOf(f.plan, 0).extension() == ".exr"; }

// Rows [f.row, f.row + rows) of the present picture, counted from its top.
Status drawStrip(Film& f, int rows) {
    ViewSettings s;
    s.width = f.plan.width, s.height = rows;
    s.part = {0, f.plan.height - f.row - rows, f.plan.width, f.plan.height};
    s.mode = f.mode;
    s.time = secondOf(f.plan, f.done);
    if (Status drawn = f.renderer->draw(f.project, viewIn(f.plan, f.project, f.view, f.done), s); !drawn) return drawn;
    const size_t at = static_cast<size_t>(f.row) * static_cast<size_t>(f.plan.width) * 3;
    if (isLinear(f)) {
        const std::vector<float> strip = f.renderer->readLinear();
        std::copy(strip.begin(), strip.end(), f.linear.begin() + static_cast<std::ptrdiff_t>(at));
    } else {
        const std::vector<uint8_t> strip = f.renderer->readImage();
        std::copy(strip.begin(), strip.end(), f.pixels.begin() + static_cast<std::ptrdiff_t>(at));
    }
    f.row += rows;
    return {};
}

Status writePicture(const Film& f) {
    const std::filesystem::path file = fileOf(f.plan, f.done);
    if (isLinear(f)) return writeImageExr(file, f.plan.width, f.plan.height, 3, f.linear);
    return writeImagePng(file, f.plan.width, f.plan.height, 3, f.pixels);
}

}  // namespace

Result<std::unique_ptr<Film>> startFilm(const Document& doc, Gpu& gpu, const FilmPlan& plan, const ViewCamera& view,
                                        ViewMode mode) {
    if (!doc.isOpen()) return failed("no project is open", "open or create one first");
    if (Status sound = checkFilm(plan, doc.project()); !sound) return sound.error();
    if (Status made = makeFolderOf(fileOf(plan, 0)); !made) return made.error();
    auto film = std::make_unique<Film>();
    film->plan = plan, film->view = view, film->mode = mode;
    film->project = snapshot(doc.project(), doc.tables().components);
    film->renderer = std::make_unique<Renderer>(gpu, doc.tables());
    film->frames = framesOf(plan, film->project);
    film->rows = kLeastRows;
    const size_t values = static_cast<size_t>(plan.width) * static_cast<size_t>(plan.height) * 3;
    if (isLinear(*film))
        film->linear.resize(values);
    else
        film->pixels.resize(values);
    film->begun = Clock::now();
    return film;
}

std::optional<Status> pumpFilm(Film& f, double ms) {
    const Clock::time_point start = Clock::now();
    do {
        const Clock::time_point strip = Clock::now();
        const int rows = std::min(f.rows, f.plan.height - f.row);
        if (Status drawn = drawStrip(f, rows); !drawn) return drawn;
        const double factor = std::clamp(kStripMs / std::max(msSince(strip), 0.1), 0.5, 2.0);
        f.rows = std::clamp(static_cast<int>(rows * factor), kLeastRows, f.plan.height);
        if (f.row < f.plan.height) continue;
        if (Status written = writePicture(f); !written) return written;
        f.row = 0;
        if (++f.done == f.frames) return Status{};
    } while (msSince(start) < ms);
    return {};
}

double shareOf(const Film& f) {
    const double row = static_cast<double>(f.row) / std::max(f.plan.height, 1);
    return (f.done + row) / std::max(f.frames, 1);
}

Status makeFilm(const Document& doc, Gpu& gpu, const FilmPlan& plan, const ViewCamera& view, ViewMode mode) {
    auto film = startFilm(doc, gpu, plan, view, mode);
    if (!film) return film.error();
    (*film)->rows = plan.height;
    for (;;)
        if (std::optional<Status> end = pumpFilm(**film, 1e9)) return *end;
}

void offerFilms(ScriptHost& host, std::function<Result<Gpu*>()> gpu) {
    host.film = [&host, gpu = std::move(gpu)](const FilmPlan& plan, const std::string& camera) -> Status {
        const Camera* from = findCamera(host.document.project(), camera);
        if (!from && plan.path.empty())
            return usage(camera.empty() ? "the project has no camera" : "there is no camera \"" + camera + "\"",
                         "name one, or a path");
        const Result<Gpu*> drawn = gpu();
        if (!drawn) return drawn.error();
        return makeFilm(host.document, **drawn, plan, from ? viewOf(*from) : ViewCamera{}, ViewMode::Final);
    };
}

}  // namespace sward
