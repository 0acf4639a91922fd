// Time as samples: each frame takes one sample a pixel, each at another place of it, and frames add up. A pixel is
// followed to where it was in the frame before, by the camera's motion and by how far what it shows moved itself
// (lib/motion.glsl); what was hidden then, or looks like nothing around it now, is begun anew. While nothing moves, not
// even time, a picture is the plain mean of its frames. After Yang, Liu and Salvi 2020, "A Survey of Temporal
// Antialiasing Techniques", sections 3 and 4; places within a pixel by Halton's sequence (1960) of bases 2 and 3.
// Does not: know of light that changes where nothing moves (shadows come after by as many frames as add up), nor of
// motion of far trees' volumes, of water, and of what forces push; there colours around a pixel bound what is kept.
// Pictures that are drawn in pieces, and false colours, take their samples in one frame. Cost: one full-screen fragment
// each pixel with some 45 look-ups, 48 bytes a pixel, and a second pose of each vertex that sways.
#pragma once
#include "scene/rows.h"

namespace sward {
// Row of the effect "post/antialias" (techniques.cpp).
const EffectRow& antialiasEffect();
}  // namespace sward
