// A blade as a particle's path p(t) = v t + g t^2 / 2, which is a quadratic Bezier with controls 0, vT/2, vT + gT^2/2
// (Boulanger, Pattanaik, Bouatouch 2006, section 3.2, in closed form: no time step, so the tip does not depend on the
// number of segments). Metres, y up, relative to the root, which is the origin.
// Convention: a blade of azimuth a leans towards (cos a, 0, sin a); its width runs along side = (-sin a, 0, cos a); its
// normal is that of its upper face, (-cos a, 0, -sin a) where it stands upright, and turns up as the blade bends.

#ifndef __cplusplus
#include "numerics/basics.h"
#include "numerics/glsl.h"
#endif

struct BladeShape {
    vec3 control;
    vec3 tip;
};

struct BladeFrame {
    vec3 position;
    vec3 tangent;  // unit, from root to tip
    vec3 side;     // unit, horizontal, across the blade
    vec3 normal;   // unit, perpendicular to tangent and to side
};

// The shape of a blade `height` long when upright (its tip would rise to it unbent), launched leanRad from the vertical
// towards the azimuth; `bend` is the drop of its tip by gravity as a share of the height. leanRad is in [-pi/2, pi/2]
// and is clamped; bend is in [0, 1] and is cut where the tip would pass below the root. No point of the blade is below
// the root.
FN BladeShape bladeShape(real height, real leanRad, real bend, real azimuth) {
    real lean = clamp(leanRad, real(-1.5707963267948966), real(1.5707963267948966));
    real rise = max(cos(lean), real(0.0));
    real reach = height * sin(lean);
    real drop = clamp(bend, real(0.0), rise);
    BladeShape shape;
    vec3 launch = vec3(reach * cos(azimuth), height * rise, reach * sin(azimuth));
    shape.control = launch * real(0.5);
    shape.tip = vec3(launch.x, height * (rise - drop), launch.z);
    return shape;
}

// The point at v of the blade, v in [0, 1].
FN vec3 bladePosition(vec3 control, vec3 tip, real v) { return control * (2.0f * v * (1.0f - v)) + tip * (v * v); }

// The frame at v in [0, 1]. A vanishing derivative falls back to the direction of the tip, then to up, so that upright
// blades with an apex, blades of height 0 and straight blades with their control at an end all have a frame.
// The normal is the tangent turned a quarter within the vertical plane of the azimuth: no cross product, nothing to
// vanish while the blade stays in its plane; out of it (wind), the normal stays perpendicular to the tangent and to the
// side.
// facing: (cos a, sin a) of the azimuth a, a unit vector.
FN BladeFrame bladeFrameFacing(vec3 control, vec3 tip, vec2 facing, real v) {
    real tiny = max(max(maxAbs3(control), maxAbs3(tip)) * real(1e-6), kTiny);
    BladeFrame f;
    f.position = bladePosition(control, tip, v);
    f.tangent = unitOr(control * (1.0f - v) + (tip - control) * v, tiny, unitOr(tip, tiny, vec3(0.0f, 1.0f, 0.0f)));
    f.side = vec3(-facing.y, real(0.0), facing.x);
    vec3 inPlane = vec3(f.tangent.x * facing.x + f.tangent.z * facing.y, f.tangent.y, 0.0f);
    vec3 turned = unitOr(inPlane, real(1e-6), vec3(0.0f, 1.0f, 0.0f));
    f.normal = vec3(-facing.x * turned.y, turned.x, -facing.y * turned.y);
    return f;
}

FN BladeFrame bladeFrame(vec3 control, vec3 tip, real azimuth, real v) {
    return bladeFrameFacing(control, tip, vec2(cos(azimuth), sin(azimuth)), v);
}
