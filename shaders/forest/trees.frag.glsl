// A near tree's colour, diffuse, lit by sun, sky and lamps, and by what shines through its leaves, in the haze. Light
// from the sky's two halves comes past the leaves of its own crown and of the wood around (forest/tree_light.h), that
// of sun and lamps past shadow maps.
#include "lib/canopy.glsl"
#include "lib/frame.glsl"
#include "lib/lamp_shadow.glsl"
#include "lib/lamps.glsl"
#include "lib/light.glsl"
#include "lib/motion.glsl"
#include "lib/object_color.glsl"
#include "lib/shadow.glsl"
#include "numerics/forest.h"
#include "numerics/leaf.h"
#include "numerics/light.h"
#include "shared/bindings.h"
#include "shared/forest.h"

layout(binding = TEX_OBJECT) uniform sampler2D image;
layout(location = 0) uniform vec3 reflectance;  // factor of the image
layout(location = 1) uniform float cutoff;      // of its alpha
layout(location = 2) uniform float leaves;      // share of the part through which light shines at all
layout(location = 3) uniform float translucency;
layout(location = 4) uniform vec3 scatter;  // share of the light on leaves that they send on, to both sides

in vec3 position;
in vec3 normal;
in vec2 uv;
in vec3 air;
flat in float around;
in vec4 shares;
in float open;
in vec3 moved;
layout(location = 0) out vec4 color;

// Light of the sky without its glow around the sun, which comes and goes with the sun's.
vec3 evenSky() { return SUN ? frame.skyLight - frame.skyGlow * frame.sunDirection.y : frame.skyLight; }
vec3 sunAndGlow() { return frame.sunLight + frame.skyGlow; }
// Light from the sky's two halves on a surface, past leaves. shares: of both, above and below.
vec3 lightPast(vec2 shares, float floorShare, float up) {
    return halvesLight(frame.groundLight * (floorShare * shares.y), evenSky() * shares.x, up);
}
// Of the light on a leaf that is seen, what those have that it sees: they lie deeper in its crown (docs/forest.md).
const float kDeeper = 0.5;
// Light that the leaves around throw there. held: shares, of both sides.
vec3 lightOfLeaves(vec4 held, float floorShare) {
    vec2 past = 0.5 * (held.xy + held.zw);
    float sun = clamp(open, 0.0, 1.0);
    if (FOREST_VOLUMES) sun *= pow(max(lightShares(air.xy / forest.cells, air.z, FOREST_LEVEL).r, LEAST_LIGHT), around);
    return mix(1.0, kDeeper, leaves) * lightFromLeaves(scatter, SUN ? sunAndGlow() * sun : vec3(0.0),
                                                       evenSky() * past.x, frame.groundLight * (floorShare * past.y),
                                                       0.5 * (past.x + past.y));
}

// What the surface sends of all lamps' light; through: of what falls on its other side. Leaves are flat: raised as
// others are, they would leave each other's shadow.
vec3 lampsSent(vec3 n, vec3 own, vec3 through) {
    vec3 sum = vec3(0.0);
    for (int i = 0; i < lampCount(); ++i) {
        LampHere l = lampAt(i, position);
        float facing = dot(n, l.direction);
        vec3 lit = (facing < 0.0 ? -n : n) * (leaves > 0.0 ? 0.4 : 1.0);
        sum += l.light * (facing < 0.0 ? through : own) * (abs(facing) * lampVisible(i, position, lit));
    }
    return min(sum, vec3(kBrightest));
}

void main() {
    vec4 texel = texture(image, uv);
    if (texel.a < cutoff) discard;
    vec3 n = normalize(gl_FrontFacing ? normal : -normal);
    vec3 own = texel.rgb * reflectance;
    float through = leaves * translucency;
    float floorShare = FOREST_VOLUMES ? pow(max(forest.floor, LEAST_LIGHT), around) : 1.0;
    vec4 held = clamp(shares, 0.0, 1.0);  // beside slivers they are mixed beyond their corners'
    vec4 sides = gl_FrontFacing ? held : held.zwxy;
    vec3 others = lightOfLeaves(held, floorShare);
    vec3 light = own * (lightPast(sides.xy, floorShare, n.y) + others) +
                 leafThrough(own) * (through * (lightPast(sides.zw, floorShare, -n.y) + others));
    if (SUN) {
        float facing = dot(n, frame.sunDirection);
        vec3 lit = facing < 0.0 ? -n : n;
        vec3 sent = facing < 0.0 ? leafThrough(own) * through : own;
        light += sunAndGlow() * sent * (abs(facing) * sunPastMeshes(position, lit));
    }
    if (LAMPS) light += lampsSent(n, own, leafThrough(own) * through);
    color = objectColor(light, n, position);
    tellMotion(moved);
}
