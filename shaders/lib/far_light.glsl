// How a place on the horizontal slice is lit: what it stores of its blades, by the light here (Boulanger, Pattanaik and
// Bouatouch 2006, sections 3.3 and 4.1). Fragment shaders only. Needs: what lib/far.glsl needs; const int STORAGE;
// const bool LIGHT_COSINE, SUN, LAMPS.
#include "lib/far.glsl"
#include "lib/frame.glsl"
#include "lib/lamp_shadow.glsl"
#include "lib/lamps.glsl"
#include "lib/slices.glsl"

// The light in which the slice lies.
struct FarLit {
    SunSeen sun;
    mat3 toField;   // from the world's axes to the field's
    vec3 at;        // relative to the eye
    vec3 raise;     // unit normal of the object on which it lies, 0 on the ground
    vec3 ambient;   // with its gain
    float visible;  // share of the sun that is seen from there
    vec3 gain;      // of the sun's light
    vec3 brighter;  // of lamps' light
    vec3 hotSpot;   // of the sun's (lib/slices.glsl)
};

// A lamp's light there, with its gain, and its five weights.
struct FarLamp {
    vec3 light;
    vec4 weights;
};
FarLamp farLamp(int i, FarLit here) {
    LampHere l = lampReaching(i, here.at, here.raise);
    vec3 direction = here.toField * l.direction, toEye = here.toField * (-here.at / max(length(here.at), 1e-4));
    FarLamp lamp;
    lamp.light = l.light * here.brighter * lampGain(toEye, direction).y;
    lamp.weights = lampWeights(direction) * lampFade(direction);
    return lamp;
}

// Five weights as weights of a cell's images: x+, x-, z+, z-.
vec4 farImages(Repeated r, vec4 w) {
    float zNeg = 1.0 - (w.x + w.y + w.z + w.w);
    return vec4(r.mirror.x > 0.0 ? w.xw : w.wx, r.mirror.y > 0.0 ? vec2(w.z, zNeg) : vec2(zNeg, w.z));
}

vec3 farLampsSend(Repeated r, vec3 reflectance, vec4 lit, vec2 above, FarLit here) {
    vec3 sum = vec3(0.0);
    for (int i = 0; i < lampCount(); ++i) {
        FarLamp l = farLamp(i, here);
        sum += l.light * reflectance * (dot(farImages(r, l.weights), lit) + l.weights.y * above.x);
    }
    return sum;
}

// Of images of colours, one a light: x+, x-, z+, z-, and above; `upper`: the sun's weight of the last. Light through
// leaves is what the opposite light does, but from above, of which the other view has it.
vec3 farFullSends(sampler2DArray lightImages, Repeated r, vec4 images, float upper, vec3 sun, FarLit here) {
    vec3 image[5];
    for (int i = 0; i < 5; ++i) image[i] = textureGrad(lightImages, vec3(r.texel.xy, float(i)), r.dx, r.dy).rgb;
    vec3 send = upper * image[4];
    for (int i = 0; i < 4; ++i) send += images[i] * image[i];
    if (TRANSLUCENCY) {
        vec3 through = upper * textureGrad(lightImages, vec3(r.texel.xy, 9.0), r.dx, r.dy).rgb;
        for (int i = 0; i < 4; ++i) through += images[i] * image[i ^ 1];
        send += slices.translucency * leafThrough(through);
    }
    send *= sun * here.gain;
    if (!LAMPS) return send;
    for (int i = 0; i < lampCount(); ++i) {
        FarLamp l = farLamp(i, here);
        vec4 by = farImages(r, l.weights);
        vec3 lit = l.weights.y * image[4];
        for (int k = 0; k < 4; ++k) lit += by[k] * image[k];
        send += l.light * lit;
    }
    return send;
}

// What it sends to the eye. lightImages: the slice's; leaf: reflectance, and share of ambient light that
// reaches it; above: what it stores of light from above.
vec3 farRadiance(sampler2DArray lightImages, Repeated r, vec4 leaf, vec2 above, FarLit here) {
    vec3 light = here.ambient * leaf.rgb * leaf.a;
    if (!SUN && !LAMPS) return light;
    vec3 sun = SUN ? here.hotSpot * frame.sunLight * (frame.sunIsUp * here.visible) : vec3(0.0);
    vec4 w = here.sun.weights, images = farImages(r, w);
    if (STORAGE == FULL_STORAGE) return light + farFullSends(lightImages, r, images, w.y, sun, here);
    vec4 lit = textureGrad(lightImages, r.texel, r.dx, r.dy);
    vec3 towards = here.sun.towards * vec3(r.mirror.x, 1.0, r.mirror.y);
    vec2 send = LIGHT_COSINE ? cosineOf(vec3(lit.x, above.x, lit.z), vec3(lit.y, above.y, lit.w), towards)
                             : vec2(dot(lit, images) + above.x * w.y, dot(lit.yxwz, images) + above.y * w.y);
    light += leavesSend(leaf.rgb, send) * sun * here.gain;
    return LAMPS ? light + farLampsSend(r, leaf.rgb, lit, above, here) : light;
}
