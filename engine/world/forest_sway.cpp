#include "world/forest_sway.h"

#include "world/forest_stand.h"

namespace sward {

void TreeSway::follow(const Wind* wind, const glm::dvec2& eye, double seconds) {
    wind_ = wind;
    if (!wind_) return;
    gusts_ = &gustsOf(*wind_, made_);
    globals_ = windGlobals(*wind_, eye, seconds);
}

glm::dmat3 TreeSway::at(const Forest& forest, const glm::dvec2& foot) const {
    if (!wind_) return glm::dmat3(1);
    return leaning(glm::dvec2(windLeanAt(globals_, *gusts_, glm::vec2(foot), -1)) /
                   static_cast<double>(forest.stiffness));
}

}  // namespace sward
