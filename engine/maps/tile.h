// A tile's texels: held in memory, or lying in a file that is read whenever they are asked for, so that a map may be
// larger than memory. What was read last stays at hand for each thread (8 MB of heights); the rest is the system's,
// which keeps files in what memory is free. Does not: know of formats (tile_file.h), nor of the place of a tile in a
// map.
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/error.h"

namespace sward {

inline constexpr size_t kTilesAtHand = 256;  // of each thread: rows of two maps of 16384 texels

// Where texels lie that are not held. May be read by several threads at once.
class TexelSource {
  public:
    virtual ~TexelSource() = default;
    // Fills `out` with the bytes at `place`; with zeros what cannot be read, which is told of once.
    virtual void read(uint64_t place, std::span<std::byte> out) const = 0;
    // Why what was read may not be what the tiles held; nothing wrong otherwise.
    virtual Status sound() const = 0;
};

// Texels while somebody looks at them.
class TileTexels {
  public:
    TileTexels(const std::byte* data, size_t size, std::shared_ptr<const void> keep = {})
        : data_(data), size_(size), keep_(std::move(keep)) {}
    const std::byte* data() const { return data_; }
    size_t size() const { return size_; }  // bytes

  private:
    const std::byte* data_;
    size_t size_;
    std::shared_ptr<const void> keep_;  // of what was read from a source
};

// All tiles of a map have the same size in bytes. A copy of a tile is held, wherever the tile lies.
class Tile {
  public:
    explicit Tile(std::vector<std::byte> bytes) : held_(std::move(bytes)), size_(held_.size()) {}
    // `bytes` at a place of a source.
    Tile(std::shared_ptr<const TexelSource> source, uint64_t place, size_t bytes);
    Tile(const Tile& other);
    Tile& operator=(const Tile&) = delete;

    // Its texels, for as long as both the tile and the result live.
    TileTexels texels() const { return source_ ? read() : TileTexels(held_.data(), size_); }
    // The same for one look: until this thread looks at another tile.
    const std::byte* look() const { return source_ ? lookAtSource() : held_.data(); }
    // To be changed by its only owner; the tile must be held.
    std::byte* write();
    // Where it lies, if it is not held.
    const std::shared_ptr<const TexelSource>& source() const { return source_; }
    uint64_t place() const { return place_; }
    size_t heldBytes() const { return held_.size(); }
    // TexelSource::sound of where it lies, or of where it was copied from if that was unsound then.
    Status sound() const;

  private:
    TileTexels read() const;
    const std::byte* lookAtSource() const;
    const std::shared_ptr<const std::byte[]>& atHand() const;

    std::vector<std::byte> held_;
    std::shared_ptr<const TexelSource> source_;
    std::shared_ptr<const Status> fault_;  // of where it was copied from
    uint64_t place_ = 0, number_ = 0;      // number: of all tiles that ever had a source
    size_t size_ = 0;
};

// Whether two tiles of the same size hold the same bytes; reads nothing for a tile and itself, nor for two tiles of the
// same place.
bool sameTexels(const Tile& a, const Tile& b);

}  // namespace sward
