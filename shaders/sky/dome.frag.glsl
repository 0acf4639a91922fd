// The sky (Preetham, Shirley and Smits 1999) with the sun's disc; below the horizon the ground beyond the terrain,
// level with its corner, in the haze.
#include "lib/frame.glsl"
#include "numerics/glsl.h"
#include "numerics/basics.h"
#include "numerics/sky.h"
#include "lib/light.glsl"
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

void main() {
    vec3 d = normalize(direction);
    vec3 light = skyRadianceOf(model(), vec3(d.x, max(d.y, 0.0), d.z)) * frame.skyGain;
    bool disc = !WATER_REFLECTION || frame.mirrored < 0.5;  // water shows the sun as its own glint
    if (SUN && disc && d.y > 0.0) light += frame.sunLight * sunDisc(dot(d, frame.sunDirection));
    if (d.y < 0.0)
        light = plainLight(frame.groundLight, horizonColor(d.xz), frame.haze,
                           plainDistance(frame.eye, frame.terrainSize, d));
    if (viewMode() == VIEW_TIERS || viewMode() == VIEW_OVERDRAW || viewMode() == VIEW_DENSITY ||
        viewMode() == VIEW_NORMALS)
        light = vec3(0.0);
    color = vec4(light, 1.0);
}
