// Files into a document: images into its maps, objects and images into its folder, each as one undo step.
// Does not: read them (project/import.h, model/assets.h), nor ask for a file (panels/file_dialog.cpp).
#pragma once
#include <filesystem>
#include <string>

#include "model/document.h"
#include "project/import.h"

namespace sward {

// Reads an image into the map at `mapPath` (canonical), and where its integers span a range that into the field beside
// it; remembered as imports are. Errors of readImport; then nothing has changed.
Status importIntoMap(Document& document, const std::string& mapPath, const std::filesystem::path& file,
                     const ImportOptions& options = {});
// Sets a field that names an image or an object to this file. One that lies elsewhere is copied into the project's
// folder: objects to models/, images to images/. Errors of importAsset and checkImage; then nothing has changed.
Status chooseFile(Document& document, const std::string& fieldPath, const std::filesystem::path& file);

}  // namespace sward
