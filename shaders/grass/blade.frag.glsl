// A blade's fragment: the texture gives shape and veins; plain triangles have its mean alone.
#include "lib/blade_pixel.glsl"

void main() {
    drawBlade((grain & PLAIN_BLADE) != 0u ? vec4(species.imageColor, 1.0) : texture(bladeTexture, strip.xy));
}
