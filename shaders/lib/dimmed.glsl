// Output of passes that dim what was drawn (gpu/gpu.h, beginDimming). Fragment shaders only.
layout(location = 0, index = 0) out vec4 added;
layout(location = 0, index = 1) out vec4 factor;

// Leaves a share of a surface's light, and all of the haze's before it: a shadow lies on the surface alone.
void dimSurface(vec3 left, vec3 haze) {
    factor = vec4(left, 1.0);
    added = vec4((vec3(1.0) - left) * haze, 0.0);
}
