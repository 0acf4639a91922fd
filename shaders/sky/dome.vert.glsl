// A triangle over the whole view at depth 0, infinitely far; the sky model is made once a vertex, not once a pixel.
#include "lib/frame.glsl"
#include "numerics/sky.h"

out vec3 direction;
flat out vec3 skyA, skyB, skyC, skyD, skyE, skyScale;
flat out vec4 skySun;
void main() {
    vec2 p = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
    vec4 a = frame.invViewProj * vec4(p, 1.0, 1.0);  // on the near plane: its place is the direction
    direction = a.xyz / a.w;
    SkyModel m = skyModel(frame.skySun, ATMOSPHERE ? 0.0 : frame.turbidity);
    skyA = m.a;
    skyB = m.b;
    skyC = m.c;
    skyD = m.d;
    skyE = m.e;
    skyScale = m.scale;
    skySun = vec4(m.sun, m.night);
    gl_Position = vec4(p, 0.0, 1.0);
}
