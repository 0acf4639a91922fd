#include "techniques.h"

#include "scene/components.h"

namespace sward {

const Tables& tables() {
    static const Tables all{sharedComponentRows(), {}};
    return all;
}

}  // namespace sward
