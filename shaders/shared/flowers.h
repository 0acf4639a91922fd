// What shaders read of one kind of flowers (grass/flowers.h). Does not: say how a flower stands; numerics/flower.h
// does.
#pragma once
#include "shared/types.h"
#ifdef __cplusplus
namespace sward {
#endif

struct STD140 FlowerGlobals {
    vec3 petal;    // colours; petals are between the first two
    float height;  // m
    vec3 second;
    float variation;  // of the height, as a share
    vec3 center;
    float headSize;  // m
    vec3 stem;
    float cellSize;  // m
    float expected;  // flowers a cell
    uint seed;
    float tiling;     // of the density map as FieldGlobals has it; -1: there is none
    int made;         // 1: the image is made by the program
    float thinFrom;   // distance from which flowers are left out (m)
    float thinInv;    // lodInverse to where all are
    float widest;     // greatest widening of those left
    float headShare;  // height of the head in the image, as a share
    float leastSize;  // of a head that is drawn (m a metre of distance)
};

// A cell that flowers are drawn of.
struct FlowerCell {
    ivec2 cell;
    vec2 corner;  // relative to the eye
};

#ifdef __cplusplus
}
#endif
