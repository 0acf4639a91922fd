// The objects of a project's folder: those in models/, and how others and images come in.
// Does not: place any (panels/viewport_place.h).
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "core/error.h"

namespace sward {

inline constexpr const char* kAssetFolder = "models";
inline constexpr const char* kImageFolder = "images";

// .glb and .gltf in models/ and its folders, relative to the project's folder, sorted.
std::vector<std::string> projectAssets(const std::filesystem::path& dir);
// Copies an object, with what a .gltf refers to, into models/; a file of its name with other bytes there gives it
// another name. What it is called in the project. An object that lies in the project's folder already stays where it
// is. Unsound error that says why it is no object that can be shown; then nothing is copied.
Result<std::string> importAsset(const std::filesystem::path& dir, const std::filesystem::path& file);

// The same of an image, into images/. Errors of checkImage.
Result<std::string> importImage(const std::filesystem::path& dir, const std::filesystem::path& file);

}  // namespace sward
