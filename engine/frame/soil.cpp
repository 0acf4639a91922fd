#include "frame/soil.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace sward {
namespace {
// GLSL has no empty arrays.
std::string listed(const char* name, std::vector<int> numbers) {
    if (numbers.empty()) numbers.push_back(-1);
    return fmt::format("const int {}[{}] = int[{}]({});\n", name, numbers.size(), numbers.size(),
                       fmt::join(numbers, ", "));
}
}  // namespace

std::string soilConstants(const SoilNumbers& n) {
    return fmt::format("const int SOIL_FIELDS = {};\nconst int SOIL_SPECIES = {};\n", n.height.size(),
                       n.density.size()) +
           listed("SOIL_FIELD_OF", n.fieldOf) + listed("SOIL_DENSITY", n.density) + listed("SOIL_HEIGHT", n.height) +
           listed("SOIL_OCCLUSION", n.occlusion);
}

std::vector<std::string> soilVariants() {
    return {soilConstants({}), soilConstants({{0}, {-1}, {-1}, {-1}}),
            soilConstants({{0, 0, 1}, {0, -1, 3}, {1, -1}, {-1, 2}})};
}

}  // namespace sward
