#include "scene/accepted_picture.h"

#include "scene/components.h"
#include "scene/field_rows.h"

namespace sward {
namespace {

using A = AcceptedPicture;
constexpr Range kPixels{1, 16384, 160, 1920};
constexpr FieldRow kFields[] = {
    imageFile("file", offsetof(A, file), "the accepted picture; Accept Picture of This Camera makes it"),
    text("madeBy", offsetof(A, madeBy), "the OpenGL renderer that drew it; another may round otherwise"),
    whole("width", offsetof(A, width), "pixels", kPixels, "of the picture"),
    whole("height", offsetof(A, height), "pixels", kPixels, "of the picture"),
    whole("samplesPerPixel", offsetof(A, samplesPerPixel), "", {1, 8, 1, 8}, "samples a pixel"),
    real("seconds", offsetof(A, seconds), "s", {-1e6, 1e6, 0, 60}, "scene time of the picture"),
    under("Tolerance", real("meanOff", offsetof(A, meanOff), "of 255", {0, 255, 0, 5},
                            "how far channels may be off, as a mean over all pixels")),
    real("pixelOff", offsetof(A, pixelOff), "of 255", {0, 255, 0, 50}, "beyond this in one channel a pixel is off"),
    real("pixelsOff", offsetof(A, pixelsOff), "%", {0, 100, 0, 10}, "how many of the pixels may be off"),
    real("appearance", offsetof(A, appearance), "", {0, 1, 0, 0.1},
         "how different the grass may look, whichever blade stands where (docs/accuracy.md)"),
};

void checkPicture(const Registry& r, Entity e, const std::string& path, std::vector<ComponentFault>& faults) {
    if (!r.get<Camera>(e))
        faults.push_back(
            {"file", path + ".file: its entity has no Camera: no picture is taken; add one, or remove " + path, true});
}

}  // namespace

const ComponentRow& acceptedPictureRow() {
    static const ComponentRow row = [] {
        ComponentRow made =
            componentRow<A>("AcceptedPicture", "The picture of this camera as accepted: a test of the project.",
                            kFields, [](const void*) { return FeatureSet{}; });
        made.check = checkPicture;
        return made;
    }();
    return row;
}

const AcceptedPicture* acceptedPicture(const Project& p, const std::string& entity) {
    const Entity e = findEntity(p, entity);
    return e == kNoEntity ? nullptr : p.registry.get<AcceptedPicture>(e);
}

}  // namespace sward
