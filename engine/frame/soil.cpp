#include "frame/soil.h"

#include <fmt/format.h>

namespace sward {

std::string soilConstants(const std::vector<SoilNumbers>& fields) {
    std::string out = "#define SOIL_EACH";
    size_t species = 0;
    for (size_t i = 0; i < fields.size(); ++i) {
        out += fmt::format(" SOIL_FIELD({}, {}, {})", i, fields[i].height, fields[i].occlusion);
        for (const int map : fields[i].density) out += fmt::format(" SOIL_SPECIES({}, {})", species++, map);
        out += fmt::format(" SOIL_SHARE({})", i);
    }
    return out + "\n";
}

std::vector<std::string> soilVariants() {
    return {soilConstants({}), soilConstants({{-1, -1, {-1}}}), soilConstants({{0, 1, {2, -1}}, {-1, 3, {4}}})};
}

}  // namespace sward
