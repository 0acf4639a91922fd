#include "core/hash.h"

#define XXH_STATIC_LINKING_ONLY  // the state by value, aligned as XXH3 needs it
#include <fmt/format.h>
#include <xxhash.h>

namespace sward {

struct Hasher::State {
    XXH3_state_t xxh;
};

uint64_t hashBytes(const void* data, size_t size) { return XXH3_64bits(data, size); }
std::string hashHex(uint64_t hash) { return fmt::format("{:016x}", hash); }

Hasher::Hasher() : state_(std::make_unique<State>()) {
    XXH3_INITSTATE(&state_->xxh);
    XXH3_64bits_reset(&state_->xxh);
}
Hasher::~Hasher() = default;
void Hasher::add(const void* data, size_t size) { XXH3_64bits_update(&state_->xxh, data, size); }
uint64_t Hasher::value() const { return XXH3_64bits_digest(&state_->xxh); }

}  // namespace sward
