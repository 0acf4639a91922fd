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
using TilesAtHand = std::array<AtHand, kTilesAtHand>;

// Neighbours along a row have numbers one after another, and so do not drive each other out.
AtHand& slotOf(uint64_t number) {
    thread_local const auto tiles = std::make_unique<TilesAtHand>();
    return (*tiles)[number % kTilesAtHand];
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
}

std::byte* Tile::write() {
    CHECK(!source_);
    return held_.data();
}

const std::byte* Tile::lookAtSource() const {
    AtHand& slot = slotOf(number_);
    if (slot.number == number_) return slot.texels.get();
    const auto fresh = std::make_shared_for_overwrite<std::byte[]>(size_);
    source_->read(place_, {fresh.get(), size_});
    slot = {number_, fresh};
    return slot.texels.get();
}

TileTexels Tile::read() const {
    const std::byte* data = lookAtSource();
    return {data, size_, slotOf(number_).texels};
}

bool sameTexels(const Tile& a, const Tile& b) {
    if (&a == &b || (a.source() && a.source() == b.source() && a.place() == b.place())) return true;
    const TileTexels x = a.texels(), y = b.texels();
    return x.size() == y.size() && std::memcmp(x.data(), y.data(), x.size()) == 0;
}

}  // namespace sward
