// A blade's fragment: the texture gives shape and veins, but to plain triangles, whose coordinate across is -1.
#include "lib/blade_pixel.glsl"

void main() { drawBlade(strip.x < -0.5 ? vec4(0.5, 0.5, 0.5, 1.0) : texture(bladeTexture, strip.xy)); }
