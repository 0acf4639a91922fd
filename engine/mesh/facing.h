// Which way a mesh's triangles face, and how much of them is seen: what stands for it where it is no mesh any more.
// A leaf of area A covers A / 2 in the mean of all directions (Cauchy 1832: a closed convex surface covers A / 4, since
// of each of its places one side is hidden). Trees are turned at random about the upright, so that of normals only how
// far they rise is kept.
// Does not: know of light's colours, or of what hides what. Pure. Cost: 0.1 us a triangle.
#pragma once
#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "mesh/mesh.h"

namespace sward {

// Of each triangle (three indices), the share of its area that counts as a leaf's: 1 for a flat piece, 1/2 for a closed
// one, in between by the length of the sum of its normals. A piece is what shares corners' places.
std::vector<float> leafShares(const Mesh& mesh);

// Of each part of a mesh, the share of its counted area that is leaves, through which light shines: 1 of flat pieces, 0
// of closed ones.
std::vector<float> leafParts(const Mesh& mesh);
// The same of all parts together; 0 of a mesh without area.
float leafPart(const Mesh& mesh);

// How areas share out among normals: bin k holds those that rise (|y| of a unit normal) from k / kFacingBins on.
inline constexpr int kFacingBins = 16;
using Facing = std::array<float, kFacingBins>;  // sums to 1
// As leaves that lie in all directions.
Facing evenFacing();
// Of a mesh, by its areas times their leafShares; of one without area, evenFacing().
Facing facingOf(const Mesh& mesh);

// What is seen of it from a direction that rises by y (of a unit vector), against what is seen of leaves that lie in
// all directions: 1 in the mean of all directions.
float seenFrom(const Facing& facing, float y);
// Share of the light from one side that it sends back to the eye, against a white surface that faces the light
// (Lambert's law, the mean over what the eye sees of it). light, eye: rise of the ways to both; cosine: between them.
float sentTo(const Facing& facing, float light, float eye, float cosine);
// Likewise, of the light that falls on the sides that the eye does not see: what would shine through if all of it did.
float passedTo(const Facing& facing, float light, float eye, float cosine);
// The mean rise of the normals of what the eye sees of it, on the side that is seen; eye: rise of the way there.
float seenRise(const Facing& facing, float eye);

}  // namespace sward
