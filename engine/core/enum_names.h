// The names of an enum's values, as files, scripts and the editor's lists write them: one a value, in their order.
// `inline constexpr auto kLightTypes = enumNames<LightType>("directional", "point");` stands beside the enum.
// Does not: know enums whose values leave gaps or do not begin with 0.
#pragma once
#include <array>
#include <cstddef>
#include <string_view>
#include <type_traits>

namespace sward {

// Whether an enumerator has this value. GCC and Clang write one that has none as a cast, "[value = (LightType)7]", so
// that a digit follows the last bracket.
template <auto value>
consteval bool isEnumerator() {
    const std::string_view text = __PRETTY_FUNCTION__;
    const char next = text[text.rfind(')') + 1];
    return next < '0' || next > '9';
}

// How many values an enum has, counted from 0 to the first number that is none.
template <class E, int from = 0>
consteval size_t enumCount() {
    if constexpr (isEnumerator<static_cast<E>(from)>())
        return enumCount<E, from + 1>();
    else
        return from;
}

// An array of texts that may be asked by the enum's value, too.
template <class E>
struct EnumNames : std::array<const char*, enumCount<E>()> {
    using std::array<const char*, enumCount<E>()>::operator[];
    constexpr const char* operator[](E value) const { return (*this)[static_cast<size_t>(value)]; }
};

// The names, checked to be as many as the enum's values. The enum is stored as an int (Bool, Int and Enum fields,
// scene/rows.h).
template <class E, class... Name>
consteval EnumNames<E> enumNames(Name... names) {
    static_assert(std::is_same_v<std::underlying_type_t<E>, int>, "fields hold enums of ints");
    static_assert(sizeof...(names) == enumCount<E>(), "an enum has one name a value");
    return {{{names...}}};
}

}  // namespace sward
