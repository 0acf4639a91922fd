// Air for tests: of a tree that is an even block.
#pragma once
#include "forest/shade_map.h"

namespace sward::test {

// 4 m wide and 10 m high, from the ground up.
inline TreeAir evenAir(float extinction) {
    TreeAir a{8, 20, 0.5, 10, {}};
    a.extinction.assign(8 * 8 * 20, extinction);
    return a;
}

}  // namespace sward::test
