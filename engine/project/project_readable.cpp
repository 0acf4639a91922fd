// What cannot be opened is not saved: the reader is asked before anything is written.
#include "core/file.h"
#include "core/utf8.h"
#include "project/project_json.h"
#include "scene/field_limits.h"

namespace sward {
namespace {

Error cannotBeSaved(const Project& p, const Error& why, const char* remedy) {
    return failed("cannot be saved: " + why.message, why.remedy.empty() ? remedy : why.remedy)
        .at((p.dir / "project.json").string());
}

// PATHs begin with the entity.
std::string below(const std::string& path, const std::string& key) {
    return path.empty() || path == "entities" ? key : path + "." + key;
}

// The PATH of the first text that is not UTF-8; nothing if all are.
std::optional<std::string> foreignText(const Json& j, const std::string& path) {
    if (j.isString() && notUtf8At(j.text)) return path;
    for (size_t i = 0; i < j.array.size(); ++i)
        if (auto found = foreignText(j.array[i], fmt::format("{}[{}]", path, i))) return found;
    for (const auto& [key, value] : j.object) {
        if (notUtf8At(key)) return below(path, utf8Text(key));
        if (auto found = foreignText(value, below(path, key))) return found;
    }
    return std::nullopt;
}

}  // namespace

Status checkReadable(const Project& p, std::span<const ComponentRow> rows, const Json& tree, const std::string& text,
                     bool copy) {
    constexpr const char* kRemedy = "remove entities, or make two projects of it";
    if (Status s = checkLength(text.size(), kMaxJsonBytes); !s)
        return cannotBeSaved(p, failed(s.error().message), kRemedy);
    if (const auto path = foreignText(tree, ""))
        return cannotBeSaved(p, failed(*path + ": holds bytes that are not UTF-8", "write it in UTF-8"), "");
    const Result<Json> read = parseJson(text, "project.json");
    if (!read) return cannotBeSaved(p, failed(read.error().message), kRemedy);
    ProjectReader reader;
    reader.rows = rows;
    reader.file = "project.json";
    reader.repair = false;
    reader.read(*read);
    if (!reader.refused.empty()) return cannotBeSaved(p, reader.refused.front(), "change it, or remove some of it");
    if (copy) return {};
    if (Status s = checkFields(p); !s) return cannotBeSaved(p, s.error(), "");
    return {};
}

}  // namespace sward
