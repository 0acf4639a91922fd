#include "scene/in_folder.h"

#include "scene/field_rows.h"

namespace sward {
namespace {

constexpr FieldRow kFields[] = {
    text("folder", offsetof(InFolder, folder), "folder of the outliner in which it is listed"),
};

}  // namespace

const ComponentRow& inFolderRow() {
    static const ComponentRow row = componentRow<InFolder>("InFolder", "The outliner lists it in a folder.", kFields,
                                                           [](const void*) { return FeatureSet{}; });
    return row;
}

std::string folderOf(const Project& p, const std::string& entity) {
    const Entity e = findEntity(p, entity);
    const InFolder* in = e == kNoEntity ? nullptr : p.registry.get<InFolder>(e);
    return in ? in->folder : "";
}

}  // namespace sward
