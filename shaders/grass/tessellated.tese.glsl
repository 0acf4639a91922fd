// A vertex of a tessellated blade: on two parallel quadratic splines, with their frame (Jahrmann and Wimmer 2013,
// equations 7 and 8; J-7), lit there.
#include "lib/blade_light.glsl"
#include "lib/frame.glsl"
#include "lib/mirror.glsl"
#include "lib/tess.glsl"
#include "numerics/spline.h"

layout(quads, equal_spacing, ccw) in;

in vec4 stemRoot[], stemControl[], stemTip[], stemFacing[], stemPaint[];
in vec4 stemUpright[];
in vec3 stemControlBefore[], stemTipBefore[];
in vec3 stemSlope[];
flat in uint stemGrain[];
centroid out vec4 lit;  // as in geometry.vert.glsl
centroid out vec4 sunned;
centroid out vec2 sunward;
centroid out vec3 maskAt;
centroid out vec3 strip;  // across (-1: a plain triangle), along; opacity
flat out uint grain;
out vec3 moved;

TessBlade patchBlade() {
    TessBlade t;
    t.pose.control = stemControl[0].xyz;
    t.pose.tip = stemTip[0].xyz;
    t.pose.facing = stemFacing[0].xy;
    t.pose.upright = stemUpright[0].xyz;
    t.high = stemUpright[0].w;
    t.slope = stemSlope[0].xy;
    t.own = stemSlope[0].z;
    if (TEMPORAL) t.before.control = stemControlBefore[0], t.before.tip = stemTipBefore[0];
    t.root = stemRoot[0].xyz;
    t.uv = stemPaint[0].zw;
    t.width = stemControl[0].w;
    t.opacity = stemTip[0].w;
    t.density = stemFacing[0].w;
    t.hue = stemPaint[0].x;
    t.lightness = stemPaint[0].y;
    t.grain = stemGrain[0];
    t.level = int(stemRoot[0].w);
    t.plain = stemFacing[0].z > 0.5;
    return t;
}

void main() {
    TessBlade t = patchBlade();
    float u = gl_TessCoord.x > 0.25 ? 1.0 : 0.0,
          v = gl_TessCoord.y;  // stages put a vertex between the two of a row: there it draws nothing
    vec3 side = vec3(-t.pose.facing.y, 0.0, t.pose.facing.x), end = side * (0.5 * t.width), at;
    BladeLight light = t.level > 1 ? bentRowLight(t, v) : straightRowLight(t, straightLights(t), v);
    maskAt = light.maskAt;
    if (t.plain) {
        PlainBlade p = plainBlade(t.pose, t.width);
        at = mix(p.base, p.apex, v) + side * ((u - 0.5) * (1.0 - v) * p.width);
    } else {
        at = t.level == 1 ? middleOfRow(t, v) + end * (2.0 * u - 1.0)
                          : splineFrame(-end, t.pose.control - end, t.pose.tip - end, end, t.pose.control + end,
                                        t.pose.tip + end, side, u, v)
                                .position;
        maskAt = maskOf(t, at);
    }
    lit = light.lit, sunned = light.sunned, sunward = light.sunward;
    strip = vec3(t.plain ? 0.5 : u, v, t.opacity);
    grain = t.grain | (t.plain ? PLAIN_BLADE : 0u);
    moved = movedAt(t, v);
    cutAtWater(t.root.y + at.y);
    gl_Position = frame.viewProj * vec4(t.root + at, 1.0);
}
