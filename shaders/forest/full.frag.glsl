// Closes pixels that slices have filled: what would still come through is less than a picture shows.
#include "shared/bindings.h"

layout(binding = TEX_FOREST_VEIL) uniform sampler2D veil;

const float kFull = 0.985;

void main() {
    if (texelFetch(veil, ivec2(gl_FragCoord.xy), 0).a < kFull) discard;
}
