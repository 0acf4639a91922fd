// A plain triangle's fragment: of its texture's mean, and where the compute pass has decided whether it covers the
// pixels' only sample, without a test that would keep hidden ones from being left out early.
#include "lib/blade_pixel.glsl"

void main() {
    vec4 plain = vec4(species.imageColor, 1.0);
    if (ALL_OR_NOTHING)
        color = bladePixel(plain, 1.0);
    else
        drawBlade(plain);
}
