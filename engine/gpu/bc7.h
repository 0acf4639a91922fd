// Blocks of 4 x 4 texels in 16 bytes: BC7 (Khronos Data Format Specification 1.3, chapter 20), in its mode 6 alone: two
// colours with alpha at 8 bits, and 16 steps between. Made for premultiplied foliage, whose colours and alphas lie near
// a line. Texels of all zeros stay zeros where their whole block is.
// Does not: touch GL. Cost: 1 us a block.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

namespace sward {

using Bc7Texels = std::array<std::array<uint8_t, 4>, 16>;  // rows first, RGBA
using Bc7Block = std::array<uint8_t, 16>;

// The block that comes near to the texels.
Bc7Block bc7Encoded(const Bc7Texels& texels);
// What hardware makes of a block of mode 6; of another mode zeros.
Bc7Texels bc7Decoded(const Bc7Block& block);

// An image's blocks, row by row; edges are repeated where a side is no multiple of 4. rgba: 4 bytes a texel.
std::vector<uint8_t> bc7Image(const uint8_t* rgba, int width, int height);

}  // namespace sward
