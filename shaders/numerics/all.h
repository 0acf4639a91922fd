// Every group of formulas, in the one order in which each finds what it calls. A shader includes only what it uses.
// clang-format off
#include "numerics/basics.h"
#include "numerics/hash.h"
#include "numerics/bilinear.h"
#include "numerics/lod.h"
#include "numerics/opacity.h"
#include "numerics/blade.h"
#include "numerics/clump.h"
#include "numerics/sky.h"
#include "numerics/tonemap.h"
