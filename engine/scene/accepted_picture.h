// The picture of a camera that a person has accepted, beside the Camera: how it is drawn, where its file lies, and how
// far later pictures may be from it. `sward check --pictures` draws it anew and judges (metrics/picture_judge.h).
// Seeds are fields of the scene: the same project is the same picture. Does not: read or draw any picture.
#pragma once
#include <string>

#include "scene/project.h"
#include "scene/rows.h"

namespace sward {

struct AcceptedPicture {
    std::string file;               // PNG, in the project's folder; empty: none is accepted yet
    std::string madeBy;             // the OpenGL renderer that drew it: another may round otherwise
    int width = 640, height = 360;  // pixels
    int samplesPerPixel = 4;        // as --msaa
    float seconds = 0;              // scene time
    // What is tolerated; 0: nothing.
    float meanOff = 0.1f;       // of 255: mean over pixels and channels
    float pixelOff = 8;         // of 255: a pixel is off if one of its channels is off by more
    float pixelsOff = 1;        // per cent of the pixels that may be off
    float appearance = 0.005f;  // of metrics/appearance.h
};

const ComponentRow& acceptedPictureRow();
// That of the entity named so, or null.
const AcceptedPicture* acceptedPicture(const Project& p, const std::string& entity);

}  // namespace sward
