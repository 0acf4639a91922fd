#include "tools/path_tool.h"

#include <cmath>

namespace sward {

size_t nextPoint(const GroundPath& path, std::optional<size_t> chosen) {
    const bool atBeginning = chosen == size_t(0) && path.points.size() > 1 && !path.closed;
    return atBeginning ? 0 : path.points.size();
}

GroundPath withPoint(GroundPath path, size_t at, const glm::dvec2& place) {
    path.points.insert(path.points.begin() + static_cast<std::ptrdiff_t>(at), PathPoint{"", roundedPlace(place)});
    return path;
}

GroundPath withoutPoint(GroundPath path, size_t at) {
    path.points.erase(path.points.begin() + static_cast<std::ptrdiff_t>(at));
    return path;
}

std::optional<size_t> chosenAfterRemoval(const GroundPath& left, size_t removed) {
    if (left.points.empty()) return std::nullopt;
    return removed > 0 ? removed - 1 : 0;
}

glm::dvec2 roundedPlace(const glm::dvec2& place) { return glm::round(place * 1e3) / 1e3; }

}  // namespace sward
