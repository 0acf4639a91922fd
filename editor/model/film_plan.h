// Which pictures a screenshot or a film is made of, and where they go: one of the view, or a row of them along a
// camera's path or while the scene's time goes on. Does not: draw them (app/film.h).
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "core/error.h"
#include "scene/project.h"
#include "world/view_camera.h"

namespace sward {

inline constexpr int kLargestPicture = 16384;  // pixels a side
inline constexpr double kMostFilmFrames = 100'000;
inline constexpr double kFilmRate = 25;  // pictures a second, where none is given

struct FilmPlan {
    bool film = false;               // else one picture
    std::filesystem::path out = {};  // a film: the folder; else the file, .png or .exr
    std::string format = "png";      // of a film: png (tone-mapped) or exr (linear)
    int width = 1920, height = 1080;
    std::string path = {};  // a film: the entity whose CameraPath is followed; "": the view stands
    double fps = kFilmRate;
    double from = 0;     // seconds at which it begins, of the scene's time and of the path
    double seconds = 0;  // how long; 0: to the path's end
};

// How many pictures: one at the beginning and one each 1 / fps until `seconds` have gone.
int framesOf(const FilmPlan& plan, const Project& project);
// Where picture `i` goes: the file, or frame_0000.png and so on in the folder.
std::filesystem::path fileOf(const FilmPlan& plan, int i);
// What is looked at in picture `i`: from the path, or `view`.
ViewCamera viewIn(const FilmPlan& plan, const Project& project, const ViewCamera& view, int i);
// The scene's time in it.
double secondOf(const FilmPlan& plan, int i);
// Usage error, with what to do, for a size, rate or length that cannot be, a path that is none, an ending that is no
// picture's, a folder that is not there, and pictures that would replace others.
Status checkFilm(const FilmPlan& plan, const Project& project);
// Entities with a CameraPath that has keys, in the order of their names.
std::vector<std::string> filmPaths(const Project& project);
// A name for `plan.out` beside the project that is not taken.
std::filesystem::path freePictureName(const FilmPlan& plan, const Project& project);

}  // namespace sward
