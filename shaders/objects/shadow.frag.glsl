// Depth alone; what an image's alpha cuts out casts no shadow.
#include "shared/objects.h"
layout(binding = TEX_OBJECT) uniform sampler2D image;
layout(location = 0) uniform float cutoff;
in vec2 uv;

void main() {
    if (cutoff > 0.0 && texture(image, uv).a < cutoff) discard;
}
