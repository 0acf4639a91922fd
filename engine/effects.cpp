// The table of contents of what draws: every effect row, side by side.
#include "forest/stand.h"
#include "forest/texcells.h"
#include "forest/trees.h"
#include "grass/far_shadow.h"
#include "grass/field.h"
#include "grass/flowers.h"
#include "grass/force_outlines.h"
#include "grass/forces.h"
#include "grass/geometry.h"
#include "grass/ground_shadow.h"
#include "grass/grown.h"
#include "grass/mask.h"
#include "grass/mesh_geometry.h"
#include "grass/mesh_grass.h"
#include "grass/raytraced.h"
#include "grass/slices.h"
#include "grass/tessellated.h"
#include "objects/lamp_shadow.h"
#include "objects/mesh.h"
#include "objects/scatter.h"
#include "objects/shadow.h"
#include "post/antialias.h"
#include "post/far_blur.h"
#include "post/map_overlay.h"
#include "post/tonemap.h"
#include "reference/object_light.h"
#include "reference/traced_light.h"
#include "sky/atmosphere.h"
#include "sky/lamps.h"
#include "sky/sky.h"
#include "sky/wind.h"
#include "techniques.h"
#include "terrain/ground.h"
#include "terrain/lamp_hills.h"
#include "terrain/shade.h"
#include "water/reflection.h"
#include "water/surface.h"

namespace sward {

std::span<const EffectRow> effectRows() {
    static const EffectRow kRows[] = {
        sunEffect(),          skyEffect(),           hazeEffect(),      atmosphereEffect(),
        lampsEffect(),  // light
        windEffect(),         gustsEffect(),         groundEffect(),    groundDepthEffect(),  shadeEffect(),
        lampHillsEffect(),  // ground
        meshEffect(),         objectLightEffect(),   scatterEffect(),   shadowEffect(),
        lampShadowEffect(),                                             // objects
        forestEffect(),       treesEffect(),         texcellsEffect(),  // forest
        forcesEffect(),       forceOutlinesEffect(), maskEffect(),      tracedEffect(),       fieldEffect(),
        farDarkeningEffect(), uniqueEffect(),        geometryEffect(),  groundShadowEffect(), farEffect(),
        farShadowEffect(),    slicesEffect(),        raytracedEffect(), tessellatedEffect(),  meshGrassEffect(),
        meshGeometryEffect(),
        flowersEffect(),                           // grass
        waterEffect(),        reflectionEffect(),  // water
        antialiasEffect(),    farBlurEffect(),       tonemapEffect(),   mapOverlayEffect(),
        decalEffect(),  // the screen
    };
    return kRows;
}

}  // namespace sward
