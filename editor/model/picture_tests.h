// The accepted pictures of a project's cameras as its tests: drawn anew and judged, or accepted.
// A picture lies in pictures/, named by its camera and its content (human.1a2b3c4d.png): what was accepted before stays
// for undo, and a diff of project.json shows that another was accepted. Does not: save the project, nor draw panels.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "frame/renderer.h"
#include "metrics/picture_judge.h"
#include "model/document.h"

namespace sward {

inline constexpr const char* kPictureFolder = "pictures";

// One camera's test.
struct PictureResult {
    std::string camera;
    AcceptedPicture asked;
    PictureVerdict verdict;      // without an error
    std::optional<Error> error;  // why it could not be judged: the file, its size, or drawing
    Picture accepted, now;       // empty where they are not there
    std::string drawnBy;         // the OpenGL renderer that drew it now
    bool pass() const { return !error && verdict.pass; }
};
// "as accepted: mean …", "differs: …", or the error; names both renderers where another drew the accepted one.
std::string resultText(const PictureResult& result);
// The error map of pixels, RGB8, of the pictures' size; empty where one of them is not there.
std::vector<uint8_t> differencePicture(const PictureResult& result);

// Entities with a Camera and an AcceptedPicture that has a file, in the order of their names.
std::vector<std::string> picturesOf(const Project& project);
// Draws the camera's picture as it is asked for, and judges. The camera must be among picturesOf.
PictureResult checkPicture(Renderer& renderer, const Gpu& gpu, const Project& project, const std::string& camera);

// How a camera that has none is to be drawn; nothing: as it says, else as AcceptedPicture's defaults.
struct PictureWish {
    std::optional<std::pair<int, int>> size;
    std::optional<float> seconds;
};
// Draws the camera's picture, writes it into the project's folder, and makes it the accepted one: one undo step, or
// none where it is the same picture. Returns the file. Fails as drawing and writing do; nothing has changed then.
Result<std::string> acceptPicture(Document& document, Renderer& renderer, const Gpu& gpu, const std::string& camera,
                                  const PictureWish& wish = {});
// Removes files that acceptPicture made in the folder and that the project, as it was just saved, no longer names.
// Returns them.
std::vector<std::string> dropOldPictures(const Project& project);

}  // namespace sward
