#include "scene/features.h"

#include <array>
#include <cctype>
#include <string>

#include "core/error.h"

namespace sward {
namespace {

constexpr auto OfScene = FeatureScope::OfScene, OfField = FeatureScope::OfField;
constexpr FeatureRow kRows[] = {
#define FEATURE(bit, name, scope, help, absent) {Feature::bit, name, scope, help, absent},
#include "scene/features.inc"
#undef FEATURE
};
constexpr size_t kCount = static_cast<size_t>(Feature::Count);
static_assert(std::size(kRows) == kCount);

std::array<std::string, kCount> makeConstants() {
    std::array<std::string, kCount> out;
    for (size_t i = 0; i < kCount; ++i)
        for (const char* c = kRows[i].name; *c; ++c)
            out[i] += *c == '-' ? '_' : static_cast<char>(std::toupper(static_cast<unsigned char>(*c)));
    return out;
}

}  // namespace

std::span<const FeatureRow> featureRows() { return kRows; }

const FeatureRow& featureRow(Feature f) {
    CHECK(f < Feature::Count);
    return kRows[static_cast<size_t>(f)];
}

const char* featureConstant(Feature f) {
    static const std::array<std::string, kCount> constants = makeConstants();
    CHECK(f < Feature::Count);
    return constants[static_cast<size_t>(f)].c_str();
}

FeatureSet fieldFeatures() {
    FeatureSet all;
    for (const FeatureRow& row : kRows)
        if (row.scope == FeatureScope::OfField) all.set(static_cast<size_t>(row.feature));
    return all;
}

}  // namespace sward
