// A near tree's colour, diffuse, lit by sun, sky and lamps, and by what shines through its leaves, in the haze. Light
// from the sky and from the leaves around comes through the same air as the volumes' does, where there are volumes; the
// others' through the shadow maps.
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
in vec3 moved;
layout(location = 0) out vec4 color;

// Light from above, from below and from the leaves around.
struct Around {
    vec3 above, below, leaves;
};
Around lightAround() {
    if (!FOREST_VOLUMES) return Around(frame.skyLight, frame.groundLight, vec3(0.0));
    vec4 shares = pow(max(lightShares(air.xy / forest.cells, air.z, FOREST_LEVEL), vec4(LEAST_LIGHT)), vec4(around));
    vec3 above = frame.skyLight * shares.g,
         below = frame.groundLight * (shares.b * pow(max(forest.floor, LEAST_LIGHT), around));
    vec3 sun = SUN ? frame.sunLight * shares.r : vec3(0.0);
    return Around(above, below, lightFromLeaves(scatter, sun, above, below, 0.5 * (shares.g + shares.b)));
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
    Around from = lightAround();
    vec3 light = own * (halvesLight(from.below, from.above, n.y) + from.leaves) +
                 leafThrough(own) * (through * (halvesLight(from.below, from.above, -n.y) + from.leaves));
    if (SUN) {
        float facing = dot(n, frame.sunDirection);
        vec3 lit = facing < 0.0 ? -n : n;
        vec3 sent = facing < 0.0 ? leafThrough(own) * through : own;
        light += frame.sunLight * sent * (abs(facing) * sunPastMeshes(position, lit));
    }
    if (LAMPS) light += lampsSent(n, own, leafThrough(own) * through);
    color = objectColor(light, n, position);
    tellMotion(moved);
}
