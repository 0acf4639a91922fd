// A vertex of a tessellated blade: on two parallel quadratic splines, with their frame (Jahrmann and Wimmer 2013,
// equations 7 and 8; J-7), lit there.
#include "lib/blade_light.glsl"
#include "lib/frame.glsl"
#include "lib/mirror.glsl"
#include "lib/tess.glsl"
#include "numerics/blade.h"
#include "numerics/spline.h"

layout(quads, equal_spacing, ccw) in;

in vec4 stemRoot[], stemControl[], stemTip[], stemFacing[], stemPaint[];
in vec3 stemUpright[], stemControlBefore[], stemTipBefore[];
flat in uint stemGrain[];
centroid out vec4 lit;  // as in geometry.vert.glsl
centroid out vec4 sunned;
centroid out vec3 turned;
centroid out vec2 maskAt;
centroid out vec3 strip;  // across (-1: a plain triangle), along; opacity
flat out uint grain;
out vec3 moved;

TessBlade patchBlade() {
    TessBlade t;
    t.pose.control = stemControl[0].xyz;
    t.pose.tip = stemTip[0].xyz;
    t.pose.facing = stemFacing[0].xy;
    t.pose.upright = stemUpright[0];
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
    vec3 side = vec3(-t.pose.facing.y, 0.0, t.pose.facing.x), end = side * (0.5 * t.width);
    SplineFrame f = splineFrame(-end, t.pose.control - end, t.pose.tip - end, end, t.pose.control + end,
                                t.pose.tip + end, side, t.plain ? mix(u, 0.5, v) : u, v);
    vec3 middle = bladePosition(t.pose.control, t.pose.tip, v), across = t.plain ? end * (1.0 - v) : end, shown;
    BladeLight light = lightPoint(t, middle, f.normal, v, shown);
    lit = light.lit, sunned = light.sunned, turned = light.turned;
    maskAt = maskOf(t, middle + (2.0 * u - 1.0) * across);
    strip = vec3(t.plain ? -1.0 : u, v, t.opacity);
    grain = t.grain;
    moved = movedAt(t, v);
    cutAtWater(t.root.y + f.position.y);
    gl_Position = frame.viewProj * vec4(t.root + f.position, 1.0);
}
