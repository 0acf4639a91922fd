// A view that water mirrors ends at the water. Needs: const bool WATER_REFLECTION; frame.glsl. The stage before
// fragments. In other views clipping is off; what is written there still lies inside, because llvmpipe clips by it all
// the same.
void cutAtWater(float height) {
    if (WATER_REFLECTION) gl_ClipDistance[0] = frame.mirrored > 0.5 ? height - frame.mirrorHeight : 1.0;
}
