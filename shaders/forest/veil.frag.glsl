// Lays what slices have added up to over the scene, sample by sample.
#include "lib/veil.glsl"

out vec4 color;

void main() { color = veilAt(ivec2(gl_FragCoord.xy), MULTISAMPLED ? gl_SampleID : 0); }
