// The accepted pictures of the open project as the editor checks them: one a frame, on a snapshot, with a renderer of
// its own, so that the viewport stays as it is. Does not: judge (model/picture_tests.h), nor draw widgets.
#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/messages.h"
#include "gpu/resources.h"
#include "model/picture_tests.h"

namespace sward {

struct FrameClock;
struct PictureRun {
    std::vector<std::string> waiting;  // cameras that are to be drawn, the next one last
    size_t asked = 0;                  // how many were
    std::unique_ptr<Project> project;  // a snapshot, and what draws it, while it runs
    std::unique_ptr<Renderer> renderer;
    std::vector<PictureResult> results;
    uint64_t revision = 0;      // of the document when it began
    std::filesystem::path dir;  // of that project
    // What is looked at: of the results, and its pictures on the GPU, which followPictures brings there.
    std::string shown;
    bool showDue = false;
    Texture accepted, now, difference;
};
// Drops what was checked before. Shows why if it cannot: no project, or no accepted picture.
void startPictures(PictureRun& run, const Document& document, Messages& messages);
// Once a frame, before its widgets: draws the next picture, and says how it went after the last; what another project
// left is dropped.
void followPictures(PictureRun& run, const Document& document, Gpu& gpu, FrameClock& clock, Messages& messages);
// What is left is not drawn; results stay.
void stopPictures(PictureRun& run);
bool checking(const PictureRun& run);
// Looks at another result, from the next frame on.
void showResult(PictureRun& run, const std::string& camera);
// Takes the camera's picture as it looks now, as acceptPicture does, and says so; its result becomes one that passes.
void acceptNow(PictureRun& run, Document& document, Gpu& gpu, Messages& messages, const std::string& camera);

}  // namespace sward
