// Closes pixels that slices have filled: what would still come through is less than a picture shows.
#include "lib/frame.glsl"
#include "lib/veil.glsl"

const float kFull = 0.985;

void main() {
    float least = 1.0;
    for (int i = 0; i < (MULTISAMPLED ? frame.samples : 1); ++i)
        least = min(least, veilAt(ivec2(gl_FragCoord.xy), i).a);
    if (least < kFull) discard;
}
