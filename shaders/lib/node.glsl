// Corners of the terrain's nodes by continuous distance-dependent level of detail (Strugar 2009): a node's odd vertices
// move onto the next level's grid between two distances, so that levels meet without cracks. Vertex shaders
// only. Needs: const bool TERRAIN_HEIGHTS.
#include "lib/frame.glsl"
#include "lib/heights.glsl"
#include "shared/bindings.h"
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
    // Nodes reach over the edge of the terrain, or of the land beyond it: their vertices do not.
    vec2 limit = frame.terrainSize + frame.landReach - node.place;
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
