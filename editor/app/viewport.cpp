#include "app/viewport.h"

#include "model/document.h"

namespace sward {

bool goToCamera(const Document& document, const std::string& name, FlyCamera& view) {
    const Entity e = findEntity(document.project(), name);
    const Camera* camera = e == kNoEntity ? nullptr : document.project().registry.get<Camera>(e);
    if (camera) view = flyFrom(viewOf(*camera));
    return camera != nullptr;
}

}  // namespace sward
