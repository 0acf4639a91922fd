#include "model/assets.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/file.h"
#include "core/utf8.h"
#include "maps/map_io.h"
#include "mesh/mesh_io.h"

namespace fs = std::filesystem;

namespace sward {
namespace {

bool isAsset(const fs::path& file) {
    std::string ending = file.extension().string();
    for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return ending == ".glb" || ending == ".gltf";
}

// Where `file` is in `dir`; "": it lies elsewhere.
std::string inProject(const fs::path& dir, const fs::path& file) {
    std::error_code fault;
    const fs::path relative = fs::relative(file, dir, fault);
    return fault || relative.empty() || *relative.begin() == ".." ? "" : relative.generic_string();
}

// Whether what is to be copied to `to` is there already, byte for byte.
bool holds(const fs::path& to, const fs::path& from) {
    const Result<std::string> a = readFile(to, kMaxMeshBytes), b = readFile(from, kMaxMeshBytes);
    return a && b && *a == *b;
}

// The first of "models/bench.glb", "models/bench-2.glb" ... that is free or holds the same.
fs::path freePlace(const fs::path& folder, const fs::path& file) {
    const std::string stem = file.stem().string(), ending = file.extension().string();
    fs::path to = folder / (stem + ending);
    std::error_code fault;
    for (int n = 2; fs::exists(to, fault) && !holds(to, file); ++n)
        to = folder / fmt::format("{}-{}{}", stem, n, ending);
    return to;
}

Status copyFile(const fs::path& from, const fs::path& to) {
    const Result<std::string> bytes = readFile(from, kMaxMeshBytes);
    if (!bytes) return bytes.error();
    if (Status made = makeFolderOf(to); !made) return made;
    return writeFileAtomic(to, *bytes);
}

// What a file is called in a folder of the project to which it is copied, unless it is there already.
Result<std::string> importInto(const fs::path& dir, const char* folder, const fs::path& file) {
    const fs::path to = freePlace(dir / folder, file);
    std::error_code fault;
    if (!fs::exists(to, fault))
        if (Status copied = copyFile(file, to); !copied) return copied.error();
    return inProject(dir, to);
}

// A .gltf goes with what it refers to, into a folder of its own.
Result<std::string> importFolder(const fs::path& dir, const fs::path& file, const std::vector<std::string>& files) {
    fs::path folder = dir / kAssetFolder / file.stem();
    std::error_code fault;
    for (int n = 2; fs::exists(folder, fault); ++n)
        folder = dir / kAssetFolder / fmt::format("{}-{}", file.stem().string(), n);
    for (const std::string& name : files)
        if (Status copied = copyFile(file.parent_path() / name, folder / name); !copied) return copied.error();
    return inProject(dir, folder / file.filename());
}

}  // namespace

std::vector<std::string> projectAssets(const fs::path& dir) {
    std::vector<std::string> names;
    std::error_code fault;
    fs::recursive_directory_iterator it(dir / kAssetFolder, fs::directory_options::skip_permission_denied, fault), end;
    for (; !fault && it != end; it.increment(fault))
        if (isAsset(it->path())) names.push_back(inProject(dir, it->path()));
    std::sort(names.begin(), names.end());
    return names;
}

Result<std::string> importAsset(const fs::path& dir, const fs::path& file) {
    if (!isAsset(file))
        return unsound("is no glTF object", "drop a .glb or .gltf; Blender exports one by File, Export, glTF 2.0")
            .at(file);
    const Result<Mesh> mesh = readMesh(file.parent_path(), utf8Text(file.filename().string()));
    if (!mesh) return mesh.error();
    if (const std::string own = inProject(dir, file); !own.empty()) return own;
    std::vector<std::string> files = mesh->files;
    files.push_back(file.filename().string());
    std::sort(files.begin(), files.end());
    files.erase(std::unique(files.begin(), files.end()), files.end());
    if (files.size() > 1) return importFolder(dir, file, files);
    return importInto(dir, kAssetFolder, file);
}

Result<std::string> importImage(const fs::path& dir, const fs::path& file) {
    if (Status sound = checkImage(file); !sound) return sound.error();
    if (const std::string own = inProject(dir, file); !own.empty()) return own;
    return importInto(dir, kImageFolder, file);
}

}  // namespace sward
