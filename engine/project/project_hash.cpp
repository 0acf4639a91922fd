#include "core/file.h"
#include "core/hash.h"
#include "core/json.h"
#include "core/save_folder.h"
#include "project/project_files.h"
#include "project/project_json.h"

namespace sward {

uint64_t projectHash(const Project& p, std::span<const ComponentRow> rows) {
    Hasher h;
    const auto addText = [&](const std::string& text) { h.add(text.data(), text.size()); };
    addText(writeJson(projectJson(p, rows)));
    for (const ConstFieldRef& map : allMaps(p, rows)) {
        const uint64_t texels = static_cast<const MapField*>(map.value)->map.hash();
        h.add(&texels, sizeof(texels));
    }
    for (const ConstFieldRef& file : allFiles(p, rows)) {
        const auto path = currentFile(p.dir, *static_cast<const std::string*>(file.value));
        const auto bytes = path ? readFile(*path, kMaxMapBytes) : Result<std::string>(std::string());
        if (bytes) addText(*bytes);
    }
    return h.value();
}

}  // namespace sward
