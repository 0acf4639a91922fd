// A vertex of a tree that stands near the eye, and where in the forest's air it lies. Needs: const bool WIND,
// FOREST_VOLUMES, TEMPORAL.
#include "lib/frame.glsl"
#include "lib/mirror.glsl"
#include "lib/wind.glsl"
#include "numerics/forest.h"
#include "shared/bindings.h"
#include "shared/forest.h"

layout(std140, binding = UBO_FOREST) uniform ForestBlock { ForestGlobals forest; };
layout(location = 5) uniform float verticalScale;  // of the tree, against its mesh
layout(location = 6) uniform float bends;          // of the forest: 1 / stiffness
layout(location = 0) in vec3 meshPosition;
layout(location = 1) in vec3 meshNormal;
layout(location = 2) in vec2 meshUv;
layout(location = 3) in vec4 row0;
layout(location = 4) in vec4 row1;
layout(location = 5) in vec4 row2;
layout(location = 6) in vec2 footStored;  // lattice coordinates of its foot in the 2 x 2 cells
// How full the wood stands around: the mean of all sides, and by how much more along x and z.
layout(location = 7) in vec3 wood;
// Of the light from above and from below what leaves leave, on the normal's side and on the other one: of a tree alone,
// and in a closed wood.
layout(location = 8) in vec4 sharesAlone;
layout(location = 9) in vec4 sharesAmong;
// Of one direction above the horizon, past its own leaves: the mean, and what a way gains by the mesh's x and by its z.
layout(location = 10) in vec3 openWays;

out vec3 position;  // relative to the eye
out vec3 normal;
out vec2 uv;
out vec3 air;  // lattice coordinates as stored, and share of the forest's height
flat out float around;
out vec4 shares;  // as sharesAlone, by the trees around
out float open;   // of the sun's light among its own leaves, to the power of what is missing of the wood around
out vec3 moved;   // metres since the frame before

void main() {
    vec4 p = vec4(meshPosition, 1.0);
    position = vec3(dot(row0, p), dot(row1, p), dot(row2, p));
    // Normals follow the planes, as the inverse's columns do: what the rows stretch twice too much is taken out before.
    vec3 upright = vec3(meshNormal.x, meshNormal.y / (verticalScale * verticalScale), meshNormal.z);
    normal = vec3(dot(row0.xyz, upright), dot(row1.xyz, upright), dot(row2.xyz, upright));
    // Of one that leans they are those columns.
    if (WIND)
        normal = vec3(dot(cross(row1.xyz, row2.xyz), meshNormal), dot(cross(row2.xyz, row0.xyz), meshNormal),
                      dot(cross(row0.xyz, row1.xyz), meshNormal));
    uv = meshUv;
    air = vec3(0.0);
    around = clamp(wood.x, 0.0, 1.0);
    if (FOREST_VOLUMES) {
        air.xy = footStored + toLattice(vec2(position.x - row0.w, position.z - row2.w), forest.edge);
        air.z = (position.y - row1.w) / forest.height;
    }
    vec4 alone = max(sharesAlone, vec4(LEAST_LIGHT)), among = max(sharesAmong, vec4(LEAST_LIGHT));
    float more = dot(wood.yz, normal.xz) / max(length(normal), 1e-6);
    vec4 full = clamp(wood.x + vec4(more, more, -more, -more), 0.0, 1.0);
    shares = pow(alone, 1.0 - full) * pow(among, full);
    vec3 gain = vec3(openWays.y, 0.0, openWays.z);
    float sunward = dot(vec3(dot(row0.xyz, gain), dot(row1.xyz, gain), dot(row2.xyz, gain)), frame.sunDirection);
    open = pow(clamp(openWays.x + sunward / length(row0.xyz), LEAST_LIGHT, 1.0), 1.0 - around);
    moved = vec3(0.0);
    if (TEMPORAL && WIND) {
        vec2 foot = vec2(row0.w, row2.w);
        float strength = winds[NOW].strength * bends;
        moved.xz = (windLeanAt(foot, -1.0, strength) - windLeanBefore(foot, -1.0, strength)) * (position.y - row1.w);
    }
    cutAtWater(position.y);
    gl_Position = frame.viewProj * vec4(position, 1.0);
}
