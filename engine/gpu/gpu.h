// An OpenGL 4.5 core context and what was measured of it. Headless through EGL (no display), or a window's.
// Does not: draw. Every byte that buffers and textures hold is counted in `ledger` under its owner's name.
#pragma once
#include <epoxy/gl.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/error.h"

namespace sward {

struct Gpu {
    std::string renderer;  // GL_RENDERER
    std::string version;
    bool software = false;             // llvmpipe and its like: timer queries are wrong there
    bool watched = false;              // a graphics debugger looks on (GL_EXT_debug_tool): passes are labelled for it
    std::vector<int> sampleCounts{1};  // samples a pixel that targets may have, ascending
    std::map<std::string, int64_t> ledger;  // owner ("grass/geometry") -> bytes
    int errors = 0;                         // GL errors reported by the debug callback
    std::string lastError;
    std::shared_ptr<void> context;  // keeps a headless context alive

    // The least of sampleCounts that is `asked` at least, or the greatest: what a driver gives who asks for that many.
    int samplesFor(int asked) const;
    // Sum over the ledger: bytes that buffers and textures hold now.
    int64_t totalBytes() const;
};

// Makes a headless context current; prefers a hardware device. ExitCode::NoContext with what was tried.
Result<std::unique_ptr<Gpu>> makeHeadlessGpu();
// Makes a headless context current again, where a process has several. Nothing for a window's.
void makeCurrent(const Gpu& gpu);
// Takes the context that is current already (a window's).
Result<std::unique_ptr<Gpu>> adoptCurrentGpu();

// From here to endDimming a fragment's second output (layout index 1; shaders/lib/dimmed.glsl) says by what the colour
// that was drawn is multiplied, and its first is added: alpha and depth stay. Into one image: more cannot have it.
void beginDimming();
void endDimming();

}  // namespace sward
