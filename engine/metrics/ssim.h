// Structural similarity of luma: 1 for equal pictures, down to -1.
// Source: Wang, Bovik, Sheikh and Simoncelli, Image Quality Assessment: From Error Visibility to Structural Similarity,
// 2004, equations 13-16: windows of 11 x 11 pixels with a Gaussian of 1.5, K1 = 0.01, K2 = 0.03, peak 1. As in the
// authors' program only windows that lie wholly in the picture count. Luma: 0.2126 R' + 0.7152 G' + 0.0722 B' (BT.709)
// of the encoded values. Cost: 0.1 s at 1024x768.
#pragma once
#include "metrics/picture.h"

namespace sward {

// Similarity around each pixel. No value within 5 pixels of the edge, nor where the window holds a pixel that is not
// finite.
ErrorMap ssimMap(const PicturePair& pair);

}  // namespace sward
