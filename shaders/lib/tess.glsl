// A blade to be tessellated: whether it is drawn, how it is posed and how finely (Jahrmann and Wimmer 2013,
// sections 5.1 and 6.3). All that is decided once a blade. Any stage but fragments.
#include "lib/blade.glsl"
#include "lib/blade_light.glsl"
#include "lib/frame.glsl"
#include "lib/on_ground.glsl"
#include "lib/straight.glsl"
#include "numerics/basics.h"
#include "numerics/blade.h"
#include "numerics/opacity.h"
#include "numerics/population.h"
#include "numerics/tess.h"
#include "shared/bindings.h"
#include "shared/grass.h"
#include "shared/tess.h"

layout(std140, binding = UBO_TESS) uniform TessBlock { TessGlobals tess; };

struct TessBlade {
    BladePose pose;
    BladePose before;  // in the frame before; TEMPORAL
    vec3 root;         // relative to the eye
    vec2 uv;           // on maps (mapPlace)
    vec2 slope;        // of the ground
    float width;       // m
    float high;        // share of its height that the distance leaves
    float own;         // as Lit has it
    float opacity, density, hue, lightness;
    uint grain;
    int level;   // quads along it; 0: it is not drawn
    bool plain;  // so thin that it is one triangle
};

int levelOf(BladePose pose, vec3 root) {
    if (!(tess.pixelsPerQuad > 0.0)) return max(tessLevel(tess.mostLevel, length(root), tess.maxDistance), 1);
    return tessLevelOnScreen(frame.viewProj * vec4(root, 1.0), frame.viewProj * vec4(root + pose.tip, 1.0),
                             frame.pixels, tess.near, tess.pixelsPerQuad, tess.mostLevel);
}

// Blade number `index` of the patch in cell c. Blades that the distance thins out get narrow, so that what is left of
// them covers as much as their share says: lowered ones would be hidden among the others. Where the field ends they
// sink into the ground.
TessBlade tessBlade(TessCell c, uint index) {
    TessBlade t;
    t.level = 0;
    Blade b = blades[index];
    Stand s = standAt(CellInstance(c.cell, c.corner, c.mirror, c.shift, 1, 0.0), b, 0.0, 0.0);
    if (!exists(s)) return t;
    float distance = length(s.root), kept = densityKept(1.0, distance, Thinning(tess.missing, tess.allTo));
    float share = min(geometryOpacity(s.density * kept, 0.0, s.threshold, species.fade) / s.opacity, 1.0);
    t.high = heightKept(distance, tess.maxDistance, tess.lowerInv);
    if (!(share * t.high > 0.0)) return t;
    if (TEMPORAL) t.before = poseBefore(b, s);
    t.pose = poseHere(b, s, t.lightness);
    t.pose.control *= t.high;
    t.pose.tip *= t.high;
    if (TEMPORAL) {
        t.before.control *= t.high;
        t.before.tip *= t.high;
    }
    t.lightness *= b.lightness;
    t.hue = b.hue;
    t.root = s.root;
    t.uv = s.uv;
    t.slope = groundSlope(s.ground, s.root.y, species.maskReach);
    t.density = s.density;
    t.opacity = s.opacity;
    t.grain = floatBitsToUint(b.dither);
    float stoodFor = min(1.0 / max(kept, 1e-3), max(tess.widest, distance * tess.widerAMetre));
    t.width = share * b.width * frame.widening * stoodFor;
    t.own = inversesqrt(max(stoodFor, 1.0));
    t.level = min(levelOf(t.pose, s.root), max(int(c.level), 1));
    t.plain = t.level == 1 && t.width * tess.pixelsPerMetre < tess.plainPixels * distance;
    return t;
}

// Metres that a row of it moved since the frame before.
vec3 movedAt(TessBlade t, float v) {
    if (!TEMPORAL) return vec3(0.0);
    return bladePosition(t.pose.control, t.pose.tip, v) - bladePosition(t.before.control, t.before.tip, v);
}

// A point of it as it would be if the distance lowered neither it nor those about it: they stand as close as ever.
vec3 unlowered(TessBlade t, vec3 fromRoot) { return fromRoot / max(t.high, 0.02); }

// Where in the shadow mask a vertex of it is: the mask is looked up as high as the curve lies in the mean.
vec3 maskOf(TessBlade t, vec3 fromRoot) {
    if (!(BLADE_SHADOWS && CASTING_LIGHTS && frame.sunCasts > 0.0)) return vec3(0.0);
    if (t.level > 1) fromRoot += overChords(t.pose, t.level);
    return maskFor(inFullHeight(unlowered(t, fromRoot), t.uv), uintBitsToFloat(t.grain), t.pose.upright, t.slope,
                   frame.sunDirection);
}

// Light on the middle of a row of it. shown: the normal that is seen.
BladeLight lightPoint(TessBlade t, float v, out vec3 shown) {
    BladeFrame f = bladeFrameFacing(t.pose.control, t.pose.tip, t.pose.facing, v);
    vec3 position = t.root + f.position;
    shown = dot(f.normal, position) > 0.0 ? -f.normal : f.normal;
    float lacked = t.level > 1 ? middleLacked(t.level) : 0.0;
    return lightOnGround(Lit(bladeColor(t.hue, t.lightness, v, lacked, t.uv), shown, unitOr(-position, 1e-6, shown),
                             position, unlowered(t, f.position), uintBitsToFloat(t.grain), t.pose.upright, t.slope,
                             mix(species.rootOpen, 1.0, v), t.density, 1.0, t.own),
                         t.uv);
}
// Light of the rows that the light of a blade of one quad is made of.
struct StraightLights {
    BladeLight low, tip;
};
StraightLights straightLights(TessBlade t) {
    vec3 shown;
    BladeLight low = lightPoint(t, species.lightRow, shown), tip = lightPoint(t, 1.0, shown);
    if (viewMode() == VIEW_NORMALS) low.lit.rgb = tip.lit.rgb = shown * 0.5 + 0.5;
    return StraightLights(low, tip);
}
// Of a row v of its vertices.
BladeLight straightRowLight(TessBlade t, StraightLights lights, float v) {
    return straightLight(lights.low, lights.tip, t.plain ? plainRow(v) : v);
}
// Light for a row v of the vertices of a blade of more.
BladeLight bentRowLight(TessBlade t, float v) {
    vec3 shown;
    BladeLight l = lightPoint(t, v, shown);
    if (viewMode() == VIEW_NORMALS) l.lit.rgb = shown * 0.5 + 0.5;
    return l;
}
// Middle of a row of its vertices, relative to the root. Where blades have one quad even near the eye, that is all
// there is of them.
vec3 middleOfRow(TessBlade t, float v) {
    if (t.level == 1 && tess.mostLevel > 1.0) return straightRow(t.pose, v);
    return bladePosition(t.pose.control, t.pose.tip, v);
}
