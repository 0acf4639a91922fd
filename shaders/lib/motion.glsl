// How far what is drawn moved by itself since the frame before, for whoever follows it from picture to picture
// (post/antialias.frag.glsl). Only passes whose row says that what they draw moves have a target for it. Fragment
// shaders only. Needs: const bool TEMPORAL.
layout(location = 1) out vec4 motion;

// moved: metres along x, y and z.
void tellMotion(vec3 moved) {
    if (TEMPORAL) motion = vec4(moved, 1.0);
}
