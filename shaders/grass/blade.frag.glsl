// A blade's fragment: the texture gives shape and veins; plain triangles, whose coordinate across is -1, have its mean
// alone.
#include "lib/blade_pixel.glsl"

void main() { drawBlade(strip.x < -0.5 ? vec4(species.imageColor, 1.0) : texture(bladeTexture, strip.xy)); }
