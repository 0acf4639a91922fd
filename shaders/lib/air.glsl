// Sky and air by the tables of the model "atmosphere" (sky/air_tables.h), in the frame's units.
#include "lib/frame.glsl"
#include "numerics/air_view.h"
#include "shared/bindings.h"

layout(binding = TEX_SKY) uniform sampler2D skyTable;
layout(binding = TEX_AIR) uniform sampler2D airTable;

vec3 airTableAt(sampler2D table, float across, float along) {
    ivec2 size = textureSize(table, 0);
    return textureLod(table, vec2(airTexel(across, size.x), airTexel(along, size.y)), 0.0).rgb * frame.skyGain;
}
// The sky in a direction, a unit vector; below the horizon as there.
vec3 skyInAir(vec3 towards) { return airTableAt(skyTable, airAcross(frame.skySun.xz, towards.xz), skyUp(towards.y)); }
// What the air up to a position relative to the eye fades into.
vec3 airUpTo(vec3 position) {
    return airTableAt(airTable, airAcross(frame.skySun.xz, position.xz), airAlong(length(position)));
}
