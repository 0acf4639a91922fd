// Whether a picture is still the one that was accepted (scene/accepted_picture.h), and where it is not.
// Tolerances are of three kinds, since pictures differ in three ways: a little everywhere (another driver's rounding),
// much in a few pixels (an edge that moved), or in how the grass looks. Does not: draw, nor read files.
#pragma once
#include <string>

#include "metrics/picture.h"
#include "scene/accepted_picture.h"

namespace sward {

struct PictureVerdict {
    bool pass = false;
    double meanOff = 0;     // of 255, over all pixels and channels
    double pixelsOff = 0;   // per cent
    double appearance = 0;  // distance
    std::string why;        // each tolerance that it exceeds, with both numbers; empty: it passes
};
// `pair`: the picture now, and the accepted one as its truth, without a mask. Pixels that are not finite never pass.
PictureVerdict judgePicture(const PicturePair& pair, const AcceptedPicture& tolerance);
// "mean 0.02 of 255, 0.1 % of pixels off, appearance 0.0003"
std::string verdictText(const PictureVerdict& verdict);

}  // namespace sward
