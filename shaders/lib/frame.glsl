// The frame's globals, for every stage.
#include "shared/bindings.h"
#include "shared/frame.h"

layout(std140, binding = UBO_FRAME) uniform FrameBlock { FrameGlobals frame; };
const int VIEW_FINAL = 0, VIEW_TIERS = 1, VIEW_OVERDRAW = 2, VIEW_DENSITY = 3, VIEW_DEPTH = 4, VIEW_NORMALS = 5;
const float kBrightest = 65504.0;  // the largest half: what the scene's target holds
// Terrain-relative metres as a share of what a map of tiling 1 covers: what maps are read at, times their tiling.
vec2 mapPlace(vec2 place) { return place * frame.mapShare; }
// A map's coordinates there; tiling 0: it lies on the terrain once, and its edge goes on beyond.
vec2 tiled(vec2 uv, float tiling) { return tiling > 0.0 ? uv * tiling : clamp(uv, 0.0, 1.0); }
// Level of detail of a map of this size whose texels are as long as so many metres.
float levelOver(float metres, ivec2 size) {
    vec2 texels = metres * frame.mapShare * vec2(size);
    return log2(max(max(texels.x, texels.y), 1.0));
}
int viewMode() { return frame.mode; }
