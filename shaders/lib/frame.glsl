// The frame's globals, for every stage.
#include "shared/frame.h"
layout(std140, binding = UBO_FRAME) uniform FrameBlock { FrameGlobals frame; };
const int VIEW_FINAL = 0, VIEW_TIERS = 1, VIEW_OVERDRAW = 2, VIEW_DENSITY = 3, VIEW_DEPTH = 4, VIEW_NORMALS = 5;
const float kBrightest = 65504.0;  // the largest half: what the scene's target holds
int viewMode() { return int(frame.mode.x); }
