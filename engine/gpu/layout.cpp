#include "gpu/layout.h"

#include <algorithm>
#include <array>
#include <glm/glm.hpp>
#include <type_traits>

#include "shared/cells.h"
#include "shared/flowers.h"
#include "shared/forest.h"
#include "shared/frame.h"
#include "shared/grass.h"
#include "shared/light.h"
#include "shared/objects.h"
#include "shared/slices.h"
#include "shared/soil.h"
#include "shared/terrain.h"
#include "shared/tess.h"
#include "shared/water.h"
#include "shared/wind.h"

namespace sward {
namespace {

constexpr size_t roundUp(size_t n, size_t to) { return (n + to - 1) / to * to; }

// What GLSL aligns a value of this type to; a struct within a struct as a vec4, which is std140's rule.
template <class T>
constexpr size_t alignmentOf() {
    if constexpr (std::is_array_v<T>) return alignmentOf<std::remove_extent_t<T>>();
    if constexpr (std::is_same_v<T, glm::vec2> || std::is_same_v<T, glm::ivec2> || std::is_same_v<T, glm::uvec2>)
        return 8;
    return std::is_class_v<T> ? 16 : alignof(T);
}

// A member as C++ has it, and what GLSL wants of its place.
struct Placed {
    SharedMember member;
    size_t size, alignment;  // of all of it
    bool std140,
        tightlyMade;  // whether its struct lies in uniform buffers; whether its elements are as far apart as there
};
template <class S, class M>
constexpr Placed placed(std::string_view of, std::string_view type, std::string_view name, size_t offset) {
    using Element = std::remove_extent_t<M>;
    constexpr bool std140 = alignof(S) == 16;
    return {{of, type, name, offset, sizeof(Element), sizeof(M) / sizeof(Element)},
            sizeof(M),
            alignmentOf<M>(),
            std140,
            !std::is_array_v<M> || !std140 || sizeof(Element) % 16 == 0};
}

#define MEMBER(S, type, name) placed<S, decltype(S::name)>(#S, #type, #name, offsetof(S, name)),
constexpr Placed kPlaced[] = {
#include "shared_members.inc"
};
#undef MEMBER

// Whether a member lies where GLSL puts it: after the one before, at a multiple of its alignment.
constexpr bool inPlace(std::string_view of, std::string_view name) {
    size_t end = 0;
    for (const Placed& p : kPlaced) {
        if (p.member.of != of) continue;
        const bool right = p.member.offset == roundUp(end, p.alignment) && p.tightlyMade;
        if (p.member.name == name) return right;
        end = p.member.offset + p.size;
    }
    return false;
}
#define MEMBER(S, type, name) \
    static_assert(inPlace(#S, #name), #S "::" #name " is not where GLSL puts it: order the members otherwise");
#include "shared_members.inc"
#undef MEMBER

constexpr auto kMembers = [] {
    std::array<SharedMember, std::size(kPlaced)> out{};
    std::transform(std::begin(kPlaced), std::end(kPlaced), out.begin(), [](const Placed& p) { return p.member; });
    return out;
}();

}  // namespace

std::span<const SharedMember> sharedMembers() { return kMembers; }

}  // namespace sward
