#include "model/map_import.h"

#include <fmt/format.h>

#include "model/assets.h"
#include "model/one_step.h"
#include "scene/map_fields.h"

namespace sward {

Status importIntoMap(Document& doc, const std::string& mapPath, const std::filesystem::path& file,
                     const ImportOptions& options) {
    const Result<ConstFieldRef> field = findField(doc.project(), doc.tables().components, mapPath);
    if (!field) return field.error();
    MapImport used;
    Result<Map> map = readImport(doc.project(), *field, file, options, &used);
    if (!map) return map.error();
    const bool spansRange = field->row->map->heightRange && used.range && map->info().type != PixelType::F32;
    const std::string range = spansRange ? fieldBeside(*field, *field->row->map->heightRange).path : "";
    const Status done = inOneStep(doc, "import " + mapPath, [&]() -> Status {
        if (Status set = doc.setMap(mapPath, std::move(*map), "import"); !set || range.empty()) return set;
        return doc.setField(range, fmt::format("[{}, {}]", used.range->first, used.range->second));
    });
    if (done) doc.rememberImport(mapPath, used);
    return done;
}

Status chooseFile(Document& doc, const std::string& fieldPath, const std::filesystem::path& file) {
    const Result<ConstFieldRef> field = findField(doc.project(), doc.tables().components, fieldPath);
    if (!field) return field.error();
    if (!field->row->isFile) return usage(fieldPath + " names no file");
    const std::filesystem::path& dir = doc.project().dir;
    const Result<std::string> name = field->row->isMesh ? importAsset(dir, file) : importImage(dir, file);
    return name ? doc.setField(fieldPath, *name) : name.error();
}

}  // namespace sward
