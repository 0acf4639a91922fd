// Fragments of triangles much thinner than a pixel: with several samples a pixel, what is interpolated over them runs
// outside of them, `centroid` or not, on some rasterisers by hundreds of times their size. Fragment shaders only.

// Whether a place on a strip or an image, meant to lie in [0, 1], is as little outside as coverage by samples explains.
// Where it is not, nothing that was interpolated beside it means anything, and the fragment is left out.
bool lies(vec2 place) { return all(greaterThanEqual(place, vec2(-1.001))) && all(lessThanEqual(place, vec2(2.001))); }
