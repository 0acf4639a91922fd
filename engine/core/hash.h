// Content hashes: XXH3, 64 bits. The same bytes give the same value on every machine.
// Does not: make random numbers for the scene (numerics/), nor resist an adversary.
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace sward {

// Hash of `size` bytes; `data` may be null where size is 0.
uint64_t hashBytes(const void* data, size_t size);
// Hash of the text's bytes, without a terminator.
inline uint64_t hashText(std::string_view text) { return hashBytes(text.data(), text.size()); }
// 16 lower-case hexadecimal digits.
std::string hashHex(uint64_t hash);

// The hash of what was added, however it was cut into pieces.
class Hasher {
  public:
    Hasher();
    ~Hasher();
    Hasher(const Hasher&) = delete;
    Hasher& operator=(const Hasher&) = delete;
    // Appends `size` bytes; `data` may be null where size is 0.
    void add(const void* data, size_t size);
    // Hash of all that was added so far: hashBytes of it in one piece. More may be added afterwards.
    uint64_t value() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace sward
