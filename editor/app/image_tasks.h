// Choosing an image file, which is shown small before it is taken: for a brush's shape, for a map, for the ground.
// Does not: draw the dialog (panels/image_dialog.cpp).
#pragma once
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "core/jobs.h"
#include "model/image_preview.h"

namespace sward {

class Document;

enum class ImageTask { None, Shape, Map, Heights };
struct ImageDialog {
    ImageTask task = ImageTask::None;
    bool opening = false;          // ImGui's popup is to be opened in this frame
    std::filesystem::path folder;  // whose images are listed
    std::string path;              // what is typed
    std::string error;
    std::vector<std::pair<std::string, bool>> entries;  // name, is a folder
    ImagePreview preview;                               // of the file last looked at
    Job<ImagePreview> reading;                          // of the one that is typed
    std::string readFile;                               // that it reads
    bool patient = true;                                // the preview is waited for: no person looks on
    // Of an import:
    std::string map;  // PATH of the map that it goes to
    bool flipX = false, flipZ = false;
    std::string low, high;  // what 0 and full scale stand for, as typed; empty: nothing
};

// Opens the dialog, in the folder where it was last, at first in the project's. `map` of an import.
void requestImage(ImageDialog& dialog, const Document& document, ImageTask task, const std::string& map = {});
// Goes to a folder and lists it: folders, and files that may be images by their extension.
void enterFolder(ImageDialog& dialog, const std::filesystem::path& folder);
// Has the file that is typed read for its preview, unless it is the one that is shown; takes it once it is there.
void lookAt(ImageDialog& dialog);

}  // namespace sward
