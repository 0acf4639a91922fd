// How pixels come to their samples: all in one frame, or one a frame, which add up (post/antialias.h draws by it).
// Does not: say how many of the first kind; that is the view's (ViewSettings::msaa).
#pragma once
#include "core/enum_names.h"
#include "scene/project.h"
#include "scene/rows.h"

namespace sward {

enum class Antialiasing { Msaa, Temporal };
inline constexpr auto kAntialiasings = enumNames<Antialiasing>("msaa", "temporal");

inline constexpr const char* kAntialiasSetting = "antialias";  // what sweeps call the choice

inline constexpr int kLeastFrames = 2, kMostFrames = 64;
struct Antialias {
    Antialiasing antialias = Antialiasing::Msaa;
    int frames = 16;  // temporal: that a picture is the mean of, [kLeastFrames, kMostFrames]
};

const ComponentRow& antialiasRow();
// The first by name that is temporal; null: samples are the view's.
const Antialias* temporalOf(const Project& p);
// Makes the project's pictures so: by every Antialias that it has, or by a new entity's.
void setAntialias(Project& p, Antialiasing kind);

}  // namespace sward
