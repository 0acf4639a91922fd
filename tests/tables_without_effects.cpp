// The tables for executables that draw nothing: components, but no effect, so that no GL code is linked.
#include "scene/components.h"
#include "techniques.h"

namespace sward {

const Tables& tables() {
    static const Tables all{sharedComponentRows(), {}};
    return all;
}

}  // namespace sward
