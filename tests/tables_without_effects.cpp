// For executables that draw nothing: components and techniques, but no effect, so that no GL code is linked.
#include "techniques.h"

namespace sward {

std::span<const EffectRow> effectRows() { return {}; }

}  // namespace sward
