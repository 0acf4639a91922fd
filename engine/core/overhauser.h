// The slope of a curve through points, where it passes one of them: that of the parabola through the point and both
// neighbours (Overhauser 1968, with knots of any spacing: Barry and Goldman 1988). Does not: know what the points are;
// V is anything that can be added and scaled.
#pragma once

namespace sward {

// before, after: knots (seconds, say) to the neighbours; 0 or less: there is none on this side. rateBefore, rateAfter:
// change a knot on the way from the one and to the other; not read where there is none. At an end the slope is that of
// the one side there is, and V{} without neighbours.
template <class V>
V overhauserSlope(double before, const V& rateBefore, double after, const V& rateAfter) {
    if (before <= 0 && after <= 0) return V{};
    if (before <= 0) return rateAfter;
    if (after <= 0) return rateBefore;
    return (1 / (before + after)) * (after * rateBefore + before * rateAfter);
}

}  // namespace sward
