// A blade's fragment: the strip's texture gives shape and veins.
#include "lib/blade_pixel.glsl"

void main() { drawBlade(texture(bladeTexture, strip.xy)); }
