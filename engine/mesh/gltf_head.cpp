#include "mesh/gltf_head.h"

#include <cmath>
#include <cstring>

#include "core/json.h"
#include "mesh/mesh_io.h"

namespace sward {
namespace {

constexpr const char* kAgain = "export it again";
constexpr const char* kSimpler = "make the object simpler";
constexpr double kMostWhole = 9007199254740992.0;  // up to here doubles hold every whole number

struct ListLimit {
    const char* name;
    size_t most;
};
constexpr ListLimit kLists[] = {
    {"accessors", kMaxGltfElements},   {"animations", kMaxGltfElements}, {"buffers", kMaxGltfBuffers},
    {"bufferViews", kMaxGltfElements}, {"cameras", kMaxGltfElements},    {"images", kMaxGltfImages},
    {"materials", kMaxGltfElements},   {"meshes", kMaxGltfElements},     {"nodes", kMaxGltfElements},
    {"samplers", kMaxGltfElements},    {"scenes", kMaxGltfElements},     {"skins", kMaxGltfElements},
    {"textures", kMaxGltfElements}};

const Json::Array& listIn(const Json& json, const char* name) {
    static const Json::Array kNone;
    const Json* j = json.find(name);
    return j && j->isArray() ? j->array : kNone;
}

// The JSON of a .gltf or of a .glb's first chunk.
Result<std::string> jsonText(const std::string& bytes) {
    if (!isGlb(bytes)) return bytes;
    uint32_t version = 0, length = 0;
    if (bytes.size() < 20) return unsound("is truncated: it ends within its header", kAgain);
    std::memcpy(&version, bytes.data() + 4, 4);
    std::memcpy(&length, bytes.data() + 12, 4);
    if (version != 2)
        return unsound(fmt::format("is a .glb of version {}; only 2 is read", version), "export it as glTF 2.0");
    if (length > bytes.size() - 20) return unsound("is truncated: it ends within its header", kAgain);
    std::string text = bytes.substr(20, length);
    while (!text.empty() && (text.back() == ' ' || text.back() == '\0')) text.pop_back();
    return text;
}

Status checkVersion(const Json& json) {
    const Json* asset = json.find("asset");
    const Json* version = asset ? asset->find("version") : nullptr;
    if (!version || !version->isString())
        return unsound("does not say its version (asset.version)", "export it as glTF 2.0");
    if (!version->text.starts_with("2."))
        return unsound("is of glTF version " + version->text + "; only 2.x is read", "export it as glTF 2.0");
    const Json* least = asset->find("minVersion");
    if (least && (!least->isString() || least->text != "2.0"))
        return unsound("needs a reader of glTF version " + least->text + " (asset.minVersion); this one reads 2.0",
                       "export it as glTF 2.0");
    return {};
}

Status checkCounts(const Json& json) {
    for (const ListLimit& list : kLists)
        if (const size_t n = listIn(json, list.name).size(); n > list.most)
            return unsound(fmt::format("has {} {}; the limit is {}", n, list.name, list.most), kSimpler);
    size_t primitives = 0;
    for (const Json& mesh : listIn(json, "meshes")) primitives += listIn(mesh, "primitives").size();
    if (primitives > kMaxGltfElements)
        return unsound(fmt::format("has {} primitives; the limit is {}", primitives, kMaxGltfElements), kSimpler);
    double bytes = 0;
    for (const Json& buffer : listIn(json, "buffers"))
        if (const Json* n = buffer.find("byteLength"); n && n->isNumber()) bytes += n->number;
    if (bytes > static_cast<double>(kMaxMeshBytes))
        return unsound(fmt::format("has buffers of {:.0f} MB together, beyond the limits: {} MB", bytes / 1e6,
                                   kMaxMeshBytes / 1'000'000),
                       kSimpler);
    return {};
}

// The library takes -1 as the largest number that there is.
Status checkNumbers(const Json& json) {
    for (const char* list : {"buffers", "bufferViews", "accessors"})
        for (size_t i = 0; i < listIn(json, list).size(); ++i)
            for (const char* name : {"byteLength", "byteOffset", "byteStride", "count"}) {
                const Json* n = listIn(json, list)[i].find(name);
                if (!n) continue;
                if (!n->isNumber() || n->number < 0 || n->number > kMostWhole || n->number != std::floor(n->number))
                    return unsound(fmt::format("{}[{}].{} is {}: no whole number from 0", list, i, name,
                                               n->isNumber() ? n->text : jsonTypeName(n->type)),
                                   kAgain);
            }
    return {};
}

Status checkExtensions(const Json& json) {
    for (const Json& name : listIn(json, "extensionsRequired"))
        if (name.isString() && name.text != "KHR_texture_transform" && name.text != "KHR_materials_unlit")
            return unsound("requires the extension " + name.text + ", which is not read", "export it without");
    return {};
}

}  // namespace

bool isGlb(const std::string& bytes) { return bytes.starts_with("glTF"); }

Status checkGltfHead(const std::string& bytes, const std::string& file) {
    const Result<std::string> text = jsonText(bytes);
    if (!text) return text.error();
    const Result<Json> json = parseJson(*text, file);
    if (!json) return json.error();
    for (const auto check : {checkVersion, checkNumbers, checkCounts, checkExtensions})
        if (Status s = check(*json); !s) return s;
    return {};
}

}  // namespace sward
