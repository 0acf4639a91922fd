// Shadow of a blade on the ground: what is left of its light there.
#include "lib/dimmed.glsl"

in vec3 left;
in vec3 haze;

void main() { dimSurface(clamp(left, vec3(0.0), vec3(1.0)), haze); }
