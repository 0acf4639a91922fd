// An object's colour, diffuse, lit by sun, sky and lamps, in the haze. Faces are lit on the side that is seen.
#include "lib/frame.glsl"
#include "lib/lamp_shadow.glsl"
#include "lib/light.glsl"
#include "lib/motion.glsl"
#include "lib/object_color.glsl"
#include "lib/shadow.glsl"
#include "shared/bindings.h"

layout(binding = TEX_OBJECT) uniform sampler2D image;
layout(location = 0) uniform vec3 reflectance;  // factor of the image
layout(location = 1) uniform float cutoff;      // of its alpha

in vec3 position;
in vec3 normal;
in vec2 uv;
in vec3 around;  // of the side that looks outside
layout(location = 0) out vec4 color;

void main() {
    vec4 texel = texture(image, uv);
    if (texel.a < cutoff) discard;
    vec3 n = normalize(gl_FrontFacing ? normal : -normal);
    vec3 from = sunLight(n) * sunVisible(position, n);
    if (LAMPS) from += lampLight(position, n, n);
    vec3 light = (from + ambientLightOn(n, gl_FrontFacing ? around : vec3(-1.0))) * texel.rgb * reflectance;
    color = objectColor(light, n, position);
    tellMotion(vec3(0.0));
}
