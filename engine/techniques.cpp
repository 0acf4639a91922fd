#include "techniques.h"

#include "grass/geometry.h"
#include "grass/ground_shadow.h"
#include "grass/mask.h"
#include "post/tonemap.h"
#include "scene/components.h"
#include "sky/lamps.h"
#include "sky/sky.h"
#include "terrain/ground.h"

namespace sward {

const Tables& tables() {
    static const EffectRow effects[] = {
        sunEffect(), skyEffect(), hazeEffect(), lampsEffect(),  // light
        groundEffect(),                           // ground
        maskEffect(), geometryEffect(), groundShadowEffect(),                         // grass
        tonemapEffect(), decalEffect(),           // the screen
    };
    static const Tables all{sharedComponentRows(), effects};
    return all;
}

}  // namespace sward
