// Ground by continuous distance-dependent level of detail (Strugar 2009): a node's odd vertices move onto the next level's
// grid between two distances, so that levels meet without cracks.
#include "lib/frame.glsl"
#include "numerics/glsl.h"
#include "numerics/bilinear.h"
#include "lib/heights.glsl"

layout(std140, binding = UBO_NODES) uniform NodeBlock { TerrainNode nodes[NODES_PER_DRAW]; };
layout(location = 0) in vec2 corner;  // 0..16

out vec3 position;   // relative to the eye
out vec2 place;      // relative to the terrain's corner, metres
out vec3 normal;

void main() {
    TerrainNode node = nodes[gl_InstanceID];
    float spacing = node.level.x;
    vec2 local = corner * spacing;
    vec2 limit = frame.terrain.xy - node.place.zw;      // nodes reach over the terrain's edge: their vertices do not
    vec2 flatRelative = node.place.xy + min(local, limit);
    float above = max(frame.eye.w, 0.0);
    float d = sqrt(dot(flatRelative, flatRelative) + above * above);
    float morph = clamp((d - node.level.y) * node.level.z, 0.0, 1.0);
    vec2 odd = fract(corner * 0.5) * 2.0;
    local = min(local - odd * spacing * morph, limit);
    place = node.place.zw + local;
    position = vec3(node.place.x + local.x, groundHeight(place), node.place.y + local.y);
    normal = groundNormal(place, spacing * (1.0 + morph));
    gl_Position = frame.viewProj * vec4(position, 1.0);
}
