// A blade to be tessellated: whether it is drawn, how it is posed and how finely (Jahrmann and Wimmer 2013,
// sections 5.1 and 6.3). All that is decided once a blade. Any stage but fragments.
#include "lib/blade.glsl"
#include "lib/blade_light.glsl"
#include "lib/frame.glsl"
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
    float width;       // m
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
    Stand s = standAt(CellInstance(c.cell, c.corner, c.mirror, c.shift, 0.0, 0.0), b, 0.0, 0.0);
    if (!exists(s)) return t;
    float distance = length(s.root), kept = densityKept(1.0, distance, tess.thinning);
    float share = min(geometryOpacity(s.density * kept, 0.0, s.threshold, species.fade) / s.opacity, 1.0),
          high = heightKept(distance, tess.maxDistance, tess.lowerInv);
    if (!(share * high > 0.0)) return t;
    if (TEMPORAL) t.before = poseBefore(b, s);
    t.pose = poseHere(b, s, t.lightness);
    t.pose.control *= high;
    t.pose.tip *= high;
    if (TEMPORAL) {
        t.before.control *= high;
        t.before.tip *= high;
    }
    t.lightness *= b.lightness;
    t.hue = b.hue;
    t.root = s.root;
    t.uv = s.uv;
    t.density = s.density;
    t.opacity = s.opacity;
    t.grain = floatBitsToUint(b.dither);
    t.width = share * b.width * frame.widening * min(1.0 / max(kept, 0.01), tess.widest);
    t.level = min(levelOf(t.pose, s.root), max(int(c.level), 1));
    t.plain = t.level == 1 && t.width * tess.pixelsPerMetre < tess.plainPixels * distance;
    if (t.plain) t.width *= tess.plainWidth;
    return t;
}

// Metres that a row of it moved since the frame before.
vec3 movedAt(TessBlade t, float v) {
    if (!TEMPORAL) return vec3(0.0);
    return bladePosition(t.pose.control, t.pose.tip, v) - bladePosition(t.before.control, t.before.tip, v);
}

// Where in the shadow mask a vertex of it is.
vec2 maskOf(TessBlade t, vec3 fromRoot) {
    if (!(BLADE_SHADOWS && CASTING_LIGHTS && frame.sunCasts > 0.0)) return vec2(0.0);
    return maskFor(inFullHeight(fromRoot, t.uv), t.pose.facing, t.pose.upright, frame.sunDirection);
}

// Light on the middle of a row of it; normal: either of the two. shown: the normal that is seen.
BladeLight lightPoint(TessBlade t, vec3 fromRoot, vec3 normal, float v, out vec3 shown) {
    vec3 position = t.root + fromRoot;
    shown = dot(normal, position) > 0.0 ? -normal : normal;
    BladeLight l = lightBlade(Lit(bladeColor(t.hue, t.lightness, v, middleLackedEvenly(t.level), t.uv), normal, shown,
                                  unitOr(-position, 1e-6, shown), position, fromRoot, t.pose.facing, t.pose.upright,
                                  mix(species.rootOpen, 1.0, v), t.density, 1.0),
                              t.uv);
    if (viewMode() == VIEW_NORMALS) l.lit.rgb = shown * 0.5 + 0.5;
    return l;
}
