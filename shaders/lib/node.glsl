// Corners of the terrain's nodes by continuous distance-dependent level of detail (Strugar 2009): a node's odd vertices
// move onto the next level's grid between two distances, so that levels meet without cracks. Needs: frame.glsl;
// numerics/glsl.h, numerics/bilinear.h; heights.glsl.
#include "shared/terrain.h"
layout(std140, binding = UBO_NODES) uniform NodeBlock { TerrainNode nodes[NODES_PER_DRAW]; };
layout(location = 0) in vec2 corner;  // 0..16

struct NodeCorner {
    vec3 position;  // relative to the eye
    vec2 place;     // relative to the terrain's corner, metres
    float spacing;  // of vertices here
};
NodeCorner nodeCorner() {
    TerrainNode node = nodes[gl_InstanceID];
    float spacing = node.spacing;
    vec2 local = corner * spacing;
    vec2 limit = frame.terrainSize - node.place;  // nodes reach over the terrain's edge: their vertices do not
    vec2 flatRelative = node.corner + min(local, limit);
    float above = max(frame.eyeAbove, 0.0);
    float d = sqrt(dot(flatRelative, flatRelative) + above * above);
    float morph = clamp((d - node.morphFrom) * node.morphInv, 0.0, 1.0);
    vec2 odd = fract(corner * 0.5) * 2.0;
    local = min(local - odd * spacing * morph, limit);
    NodeCorner c;
    c.place = node.place + local;
    c.position = vec3(node.corner.x + local.x, groundHeight(c.place), node.corner.y + local.y);
    c.spacing = spacing * (1.0 + morph);
    return c;
}
