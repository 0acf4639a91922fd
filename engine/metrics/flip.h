// LDR-FLIP: how different two pictures look to one who flips between them on a screen; 0 to 1 a pixel.
// Source: Andersson, Nilsson, Akenine-Moller, Oskarsson, Astrom and Fairchild, FLIP: A Difference Evaluator for
// Alternating Images, HPG 2020. Colour: both pictures filtered by the contrast sensitivity of the eye (section 4.1.1,
// table 1) in YCxCz, distance HyAB in Hunt-adjusted L*a*b* (4.1.2), to the power of 0.7 and spread over [0,1] by
// equation 7. Features: edges and points of the unfiltered achromatic channel by derivatives of a Gaussian (4.2).
// Together: colour to the power of 1 - feature (4.3). Cost: 1 s at 1024x768.
#pragma once
#include "metrics/picture.h"

namespace sward {

inline constexpr double kPixelsPerDegree = 67;  // the paper's screen: 3840 pixels over 0.7 m seen from 0.7 m

// The difference at each pixel; no value where the filters reach a pixel that is not finite. Edges repeat the outermost
// pixel. pixelsPerDegree: above 0. A linear pair is taken as linear and clamped to [0,1].
ErrorMap flipMap(const PicturePair& pair, double pixelsPerDegree = kPixelsPerDegree);

}  // namespace sward
