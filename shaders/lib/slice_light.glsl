// How a place on a vertical slice is lit: what it stores of its blades, by the light here (Boulanger, Pattanaik and
// Bouatouch 2006, section 3.3). Fragment shaders only. Needs: what lib/slices.glsl needs; const int
// STORAGE; const bool LIGHT_COSINE, SUN, LAMPS.
#include "lib/slices.glsl"

// A place on a slice.
struct SliceSpot {
    vec3 texel;        // across (it repeats), up, layer
    float visible;     // share of the sun that is seen from there
    vec4 images;       // of the sun (sunImages)
    float lightLayer;  // 0 in front of the slice, slices.layers behind it
    vec3 gain;         // of light from the sun
    vec3 brighter;     // of lamps' light
    vec3 ambient;
    vec4 lamp[3];  // red, green, blue: lamps' light on the images
    float fine;    // level of detail of what is lit
};

// Lamps on the images: facing, side +, side -, above.
vec3 lampsSend(SliceSpot s, vec3 reflectance, vec4 lit, float above) {
    if (!LAMPS) return vec3(0.0);
    vec4 numbers = vec4(lit.xzw, above);
    return reflectance * s.brighter * vec3(dot(s.lamp[0], numbers), dot(s.lamp[1], numbers), dot(s.lamp[2], numbers));
}

// What images of colours send, one a light and view: facing, side +, side -, above are the images 0, 2, 3, 4. Light
// through leaves is what the opposite light does on this side: from the sides in turn, from above that of the other
// view.
vec3 fullSends(SliceSpot s, bool front) {
    float layers = float(textureSize(sliceReflectance, 0).z), own = s.texel.z + (front ? 0.0 : 5.0 * layers),
          other = s.texel.z + (front ? 5.0 * layers : 0.0);
    vec3 facing = textureLod(sliceLight, vec3(s.texel.xy, own), s.fine).rgb,
         sidePlus = textureLod(sliceLight, vec3(s.texel.xy, own + 2.0 * layers), s.fine).rgb,
         sideMinus = textureLod(sliceLight, vec3(s.texel.xy, own + 3.0 * layers), s.fine).rgb,
         above = textureLod(sliceLight, vec3(s.texel.xy, own + 4.0 * layers), s.fine).rgb;
    vec3 sun = s.images.x * facing + s.images.y * sidePlus + s.images.z * sideMinus + s.images.w * above;
    if (TRANSLUCENCY) {
        vec3 below = textureLod(sliceLight, vec3(s.texel.xy, other + 4.0 * layers), s.fine).rgb;
        vec3 through = s.images.y * sideMinus + s.images.z * sidePlus + s.images.w * below +
                       (1.0 - dot(s.images, vec4(1.0))) * facing;
        sun += slices.translucency * leafThrough(through);
    }
    vec3 sent = sun * s.gain * s.visible;
    if (!LAMPS) return sent;
    vec3 lamp[4] = vec3[4](facing, sidePlus, sideMinus, above);
    for (int i = 0; i < 4; ++i) sent += s.brighter * vec3(s.lamp[0][i], s.lamp[1][i], s.lamp[2][i]) * lamp[i];
    return sent;
}

// What it sends to the eye. open: share of ambient light that reaches it; stored: the texel's thresholds and light from
// above.
vec3 sliceRadiance(SliceSpot s, vec3 reflectance, float open, vec4 stored) {
    bool front = !(s.lightLayer > 0.0);
    float above = front ? stored.z : stored.w, below = front ? stored.w : stored.z;
    vec3 light = s.ambient * reflectance * open;
    if (STORAGE == FULL_STORAGE) return light + fullSends(s, front);
    vec4 lit = textureLod(sliceLight, vec3(s.texel.xy, s.texel.z + s.lightLayer), s.fine);
    vec2 sun = LIGHT_COSINE ? cosineOf(vec3(lit.x, lit.z, above), vec3(0.0, lit.w, below), s.images.xyz)
                            : vec2(dot(s.images, vec4(lit.xzw, above)),
                                   dot(s.images, vec4(0.0, lit.wz, below)) + (1.0 - dot(s.images, vec4(1.0))) * lit.x);
    return light + leavesSend(reflectance, sun) * s.gain * s.visible + lampsSend(s, reflectance, lit, above);
}
