// The shape of a brush: a grey picture whose light, 0 to 1, is what a stamp weighs there, instead of a round falloff.
// It fills the square around the ring, its longer side from edge to edge; its upper edge is north (-z) until it is
// turned. Beyond the picture a stamp weighs nothing.
// Does not: paint; ask a person for files.
#pragma once
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "brushes/brush.h"
#include "core/error.h"

namespace sward {

// Half as wide and as high as the one before it, each texel the mean of four; with a rim of zeros, one texel before
// and two behind, so that reading beside the picture needs no question.
struct ShapeLevel {
    int width = 0, height = 0;  // without the rim
    std::vector<float> texels;  // (width + 3) x (height + 3)
};
struct BrushShape {
    std::string name;                // of one that is made here, or the file's path
    std::vector<ShapeLevel> levels;  // the finest first, down to one texel
};
using ShapePtr = std::shared_ptr<const BrushShape>;

// Of width x height numbers in [0, 1], the upper row first; others are clamped, and what is no number is 0.
ShapePtr makeShape(const std::string& name, int width, int height, std::vector<float> texels);
// From an image file: the luminance of its colours (Rec. 709), times its opacity. Floats that leave [0, 1], as heights
// in metres do, are spread from their least to their greatest; sides beyond 2048 texels are halved. Unsound errors as
// readMap gives them; texels that are not finite take the nearest that is.
Result<ShapePtr> loadShape(const std::filesystem::path& file);
// Those that are made here: "square", "splatter", "cracks", "mountain".
std::span<const char* const> builtInShapes();
// One of them by its name; null if there is none. Made anew by each call: 256 x 256, about 5 ms.
ShapePtr builtInShape(const std::string& name);

// The light of a stamp's shape along the rows of a tile; bilinear in the level whose texels are as wide as the map's.
class ShapeRows {
  public:
    ShapeRows(const Stamp& stamp, const BrushSettings& brush, int tx, int ty);
    // False: the brush has no shape, and row must not be called.
    bool any() const { return level_ != nullptr; }
    // Of row y of the tile, kTileSize numbers in [0, 1]. False if the picture lies beside the row, and all are 0.
    bool row(int y, float* light) const;
    // False if the picture lies beside the whole tile; true without a shape.
    bool reachesTile() const;

  private:
    // The first column of a row of the tile that the picture may reach, and one beyond the last; 0, 0: none.
    std::pair<int, int> columns(int y) const;

    const ShapeLevel* level_ = nullptr;
    float x0_ = 0, y0_ = 0;                    // place in the level, its rim included, of the tile's first texel ...
    float xx_ = 0, xy_ = 0, yx_ = 0, yy_ = 0;  // ... and how it changes along a row (x) and from row to row (y)
};

// The light of a shape at a place, both in [-1, 1] over the ring's square, x to the right and y down, before it is
// turned; for pictures of it.
float shapeLight(const BrushShape& shape, float x, float y);

}  // namespace sward
