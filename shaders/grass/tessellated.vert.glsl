// One blade, as one vertex of a patch of one: all that is decided once a blade.
// Jahrmann and Wimmer 2013, section 5.1, on the population's own blades (numerics/population.h).
#include "lib/tess.glsl"
#include "lib/tess_cells.glsl"
#include "shared/tess.h"

out vec4 bladeRoot;     // w: level
out vec4 bladeControl;  // w: width
out vec4 bladeTip;      // w: opacity
out vec4 bladeFacing;   // z: 1 if it is a plain triangle; w: density
out vec4 bladeUpright;  // of its pose; w: share of its height
out vec3 bladeSlope;    // of the ground; z: own, as Lit has it
out vec3 bladeControlBefore, bladeTipBefore;
out vec4 bladePaint;  // hue, lightness; where on the terrain
flat out uint bladeGrain;

void main() {
    uint slot = uint(gl_VertexID);
    TessCell c = cells[cellOf(slot)];
    TessBlade t = tessBlade(c, c.first + slot - c.slot);
    bladeRoot = bladeControl = bladeTip = bladeFacing = bladePaint = vec4(0.0);
    bladeControlBefore = bladeTipBefore = vec3(0.0);
    bladeUpright = vec4(0.0);
    bladeSlope = vec3(0.0);
    bladeGrain = 0u;
    gl_Position = vec4(0.0, 0.0, 2.0, 1.0);
    if (t.level == 0) return;
    bladeRoot = vec4(t.root, float(t.level));
    bladeControl = vec4(t.pose.control, t.width);
    bladeTip = vec4(t.pose.tip, t.opacity);
    bladeFacing = vec4(t.pose.facing, t.plain ? 1.0 : 0.0, t.density);
    bladeUpright = vec4(t.pose.upright, t.high);
    bladeSlope = vec3(t.slope, t.own);
    if (TEMPORAL) bladeControlBefore = t.before.control, bladeTipBefore = t.before.tip;
    bladePaint = vec4(t.hue, t.lightness, t.uv);
    bladeGrain = t.grain;
}
