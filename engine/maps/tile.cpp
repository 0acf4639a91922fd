#include "maps/tile.h"

#include <array>
#include <atomic>
#include <cstring>

#include "core/error.h"

namespace sward {
namespace {

struct AtHand {
    uint64_t number = 0;  // of the tile; 0: none
    std::shared_ptr<const std::byte[]> texels;
};
// Tiles whose numbers leave the same rest: the same place of up to four maps.
struct Alike {
    std::array<AtHand, 4> tiles;
    size_t oldest = 0;
};
using TilesAtHand = std::array<Alike, kTilesAtHand / 4>;

// Neighbours along a row have numbers one after another, and so do not drive each other out.
Alike& alikeOf(uint64_t number) {
    thread_local const auto tiles = std::make_unique<TilesAtHand>();
    return (*tiles)[number % tiles->size()];
}

uint64_t nextNumber() {
    static std::atomic<uint64_t> last{0};
    return ++last;
}

}  // namespace

Tile::Tile(std::shared_ptr<const TexelSource> source, uint64_t place, size_t bytes)
    : source_(std::move(source)), place_(place), number_(nextNumber()), size_(bytes) {
    CHECK(source_ != nullptr);
}

Tile::Tile(const Tile& other) : size_(other.size_) {
    const TileTexels texels = other.texels();
    held_.assign(texels.data(), texels.data() + texels.size());
    if (const Status s = other.sound(); !s) fault_ = std::make_shared<const Status>(s);
}

std::byte* Tile::write() {
    CHECK(!source_);
    return held_.data();
}

const std::shared_ptr<const std::byte[]>& Tile::atHand() const {
    Alike& alike = alikeOf(number_);
    for (const AtHand& tile : alike.tiles)
        if (tile.number == number_) return tile.texels;
    const auto fresh = std::make_shared_for_overwrite<std::byte[]>(size_);
    source_->read(place_, {fresh.get(), size_});
    AtHand& slot = alike.tiles[alike.oldest++ % alike.tiles.size()];
    slot = {number_, fresh};
    return slot.texels;
}

const std::byte* Tile::lookAtSource() const { return atHand().get(); }

TileTexels Tile::read() const {
    const std::shared_ptr<const std::byte[]>& texels = atHand();
    return {texels.get(), size_, texels};
}

Status Tile::sound() const { return fault_ ? *fault_ : source_ ? source_->sound() : Status(); }

bool sameTexels(const Tile& a, const Tile& b) {
    if (&a == &b || (a.source() && a.source() == b.source() && a.place() == b.place())) return true;
    const TileTexels x = a.texels(), y = b.texels();
    return x.size() == y.size() && std::memcmp(x.data(), y.data(), x.size()) == 0;
}

}  // namespace sward
