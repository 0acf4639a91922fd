// The sky (Preetham, Shirley and Smits 1999, or by the tables of lib/air.glsl) with the sun's disc; below the horizon
// the ground beyond the terrain, level with its corner, in the haze.
#include "lib/air.glsl"
#include "lib/frame.glsl"
#include "lib/light.glsl"
#include "numerics/light.h"
#include "numerics/sky.h"

in vec3 direction;
flat in vec3 skyA, skyB, skyC, skyD, skyE, skyScale;
flat in vec4 skySun;
out vec4 color;

SkyModel model() {
    SkyModel m;
    m.a = skyA;
    m.b = skyB;
    m.c = skyC;
    m.d = skyD;
    m.e = skyE;
    m.scale = skyScale;
    m.sun = skySun.xyz;
    m.night = skySun.w;
    return m;
}

vec3 skyLightFrom(vec3 d) { return ATMOSPHERE ? skyInAir(d) : skyRadianceOf(model(), d) * frame.skyGain; }
vec3 plain(vec3 d) {
    float distance = plainDistance(frame.eye, frame.terrainSize, d);
    return plainLight(frame.groundLight, hazeColor(d * distance), ATMOSPHERE ? frame.haze : clearHaze(frame.haze),
                      distance);
}

void main() {
    vec3 d = normalize(direction);
    vec3 light = skyLightFrom(vec3(d.x, max(d.y, 0.0), d.z));
    bool disc = !WATER_REFLECTION || frame.mirrored < 0.5;  // water shows the sun as its own glint
    if (SUN && disc && d.y > 0.0) light += frame.sunLight * sunDisc(dot(d, frame.sunDirection));
    if (d.y < 0.0) light = plain(d);
    if (viewMode() == VIEW_TIERS || viewMode() == VIEW_OVERDRAW || viewMode() == VIEW_DENSITY ||
        viewMode() == VIEW_NORMALS)
        light = vec3(0.0);
    color = vec4(light, 1.0);
}
