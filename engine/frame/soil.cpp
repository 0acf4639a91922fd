#include "frame/soil.h"

#include <fmt/format.h>

#include "shared/bindings.h"

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

std::string othersConstants(const SoilNumbers& field, size_t end) {
    if (field.density.size() < 2) return "";
    std::string out = "#define OTHERS_EACH";
    for (size_t i = 0; i < field.density.size(); ++i)
        out += fmt::format(" OTHER_SPECIES({}, {}, {})", i, end - field.density.size() + i, field.density[i]);
    return out + "\n";
}

void bindSoil(const SoilGrowth& soil) {
    glBindBufferBase(GL_UNIFORM_BUFFER, UBO_SOIL, soil.globals);
    glBindTextures(TEX_SOIL, static_cast<GLsizei>(soil.maps.size()), soil.maps.data());
}

std::vector<std::string> soilVariants() {
    return {soilConstants({}), soilConstants({{-1, -1, {-1}}}), soilConstants({{0, 1, {2, -1}}, {-1, 3, {4}}})};
}

}  // namespace sward
