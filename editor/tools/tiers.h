// The four distances of a hybrid field, near to far: minGeom < maxGeom <= minBTF < maxBTF.
// Where a value is dragged it stops at its neighbours, so that nothing moves but what is held; where it is typed it is
// taken as it is and pushes the others. Setting all four of an ordered list by pushes, in any order, gives that list.
// Does not: know widgets or undo.
#pragma once
#include <array>
#include <vector>

#include "grass/hybrid.h"

namespace sward {

inline constexpr size_t kTierCount = 4;
inline constexpr const char* kTierFields[kTierCount] = {"minGeom", "maxGeom", "minBTF", "maxBTF"};
inline constexpr double kTierGap = 0.1;  // metres over which a tier fades at least; 0 and infinity need none

using TierDistances = std::array<double, kTierCount>;  // metres; infinity: never

// As the field has them, in order or not.
TierDistances tiersOf(const HybridTiers& field);
// One field of HybridTiers, and what it is to be.
struct TierEdit {
    const char* field;
    double value;
};
// What gives a field of such blades these distances in a picture in which a metre, one metre away, is so many pixels
// wide: the metres, and by pixels what is seen there.
std::vector<TierEdit> tierEdits(const TierDistances& wanted, TiersBy by, const BladeSize& blades, float pixelsPerMetre);
// Near to far, with room for each tier to fade.
bool tiersInOrder(const TierDistances& t);
// What a drag of tier i towards `wanted` gives: as near to it as its neighbours allow; nothing new where they leave no
// room. Where these are out of order themselves they do not count.
double stoppedTier(const TierDistances& t, size_t i, double wanted);
// All four after tier i was set to `value` (at least 0): the others give way as little as they must.
TierDistances pushedTiers(TierDistances t, size_t i, double value);
// The nearest that are in order: sorted, then pushed apart from the first on.
TierDistances orderedTiers(TierDistances t);
// To what a hand can mean at this distance: 5 cm below 100 m, half a metre below 1 km, and so on.
double roundedTier(double metres);

}  // namespace sward
