#include "gpu/gpu.h"

#include <epoxy/egl.h>

#include <algorithm>
#include <cstring>

#include "core/log.h"

namespace sward {
namespace {

struct EglContext {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLContext context = EGL_NO_CONTEXT;
    // The display stays initialised: other contexts of this process share it.
    ~EglContext() {
        if (context == EGL_NO_CONTEXT) return;
        if (eglGetCurrentContext() == context) eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglDestroyContext(display, context);
    }
};

bool contextOn(EGLDisplay display, EglContext& out, std::string& tried, const std::string& what) {
    EGLint major = 0, minor = 0;
    if (display == EGL_NO_DISPLAY || !eglInitialize(display, &major, &minor)) {
        tried += what + ": no display; ";
        return false;
    }
    const EGLint attributes[] = {
        EGL_CONTEXT_MAJOR_VERSION,           4,       EGL_CONTEXT_MINOR_VERSION, 5, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    eglBindAPI(EGL_OPENGL_API);
    EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
    if (context == EGL_NO_CONTEXT || !eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) {
        tried += what + ": no OpenGL 4.5 core; ";
        if (context != EGL_NO_CONTEXT) eglDestroyContext(display, context);
        return false;
    }
    out.display = display;
    out.context = context;
    return true;
}

bool isSoftware(const std::string& renderer) {
    for (const char* name : {"llvmpipe", "softpipe", "swrast", "SWR"})
        if (renderer.find(name) != std::string::npos) return true;
    return false;
}

// EGL devices that are hardware come first; Mesa names its software device by an extension.
std::vector<EGLDeviceEXT> devicesHardwareFirst() {
    std::vector<EGLDeviceEXT> devices(16);
    EGLint count = 0;
    if (!epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_device_enumeration") &&
        !epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_device_base"))
        return {};
    if (!eglQueryDevicesEXT(16, devices.data(), &count)) return {};
    devices.resize(static_cast<size_t>(count));
    std::stable_partition(devices.begin(), devices.end(), [](EGLDeviceEXT d) {
        const char* extensions = eglQueryDeviceStringEXT(d, EGL_EXTENSIONS);
        return !extensions || !std::strstr(extensions, "EGL_MESA_device_software");
    });
    return devices;
}

// Compilers' messages come through Programs, with file names.
void GLAPIENTRY onDebug(GLenum source, GLenum type, GLuint, GLenum severity, GLsizei, const GLchar* message,
                        const void* user) {
    if (source == GL_DEBUG_SOURCE_SHADER_COMPILER || type != GL_DEBUG_TYPE_ERROR ||
        severity == GL_DEBUG_SEVERITY_NOTIFICATION)
        return;
    auto* gpu = static_cast<Gpu*>(const_cast<void*>(user));  // GL hands back what it was given, as const
    ++gpu->errors;
    gpu->lastError = message;
    logError(std::string("OpenGL: ") + message);
}

// Samples a texel that multisample textures of a format may have, and 1; ascending.
std::vector<int> sampleCountsOf(GLenum format) {
    GLint number = 0;
    glGetInternalformativ(GL_TEXTURE_2D_MULTISAMPLE, format, GL_NUM_SAMPLE_COUNTS, 1, &number);
    std::vector<int> out(static_cast<size_t>(std::max(number, 0)));
    glGetInternalformativ(GL_TEXTURE_2D_MULTISAMPLE, format, GL_SAMPLES, number, out.data());
    if (std::find(out.begin(), out.end(), 1) == out.end()) out.push_back(1);
    std::sort(out.begin(), out.end());
    return out;
}

Status describe(Gpu& gpu) {
    if (epoxy_gl_version() < 45)
        return noContext(
            fmt::format("OpenGL 4.5 is needed, the driver has {}.{}", epoxy_gl_version() / 10, epoxy_gl_version() % 10),
            "update the graphics driver, or install libgl1-mesa-dri for the software one");
    gpu.renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    gpu.version = reinterpret_cast<const char*>(glGetString(GL_VERSION));
    gpu.software = isSoftware(gpu.renderer);
    gpu.watched = epoxy_has_gl_extension("GL_EXT_debug_tool");
    gpu.sampleCounts = sampleCountsOf(GL_RGBA16F);
    std::erase_if(gpu.sampleCounts, [depths = sampleCountsOf(GL_DEPTH_COMPONENT32F)](int n) {
        return std::find(depths.begin(), depths.end(), n) == depths.end();
    });
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(onDebug, &gpu);
    glDebugMessageControl(GL_DONT_CARE, GL_DONT_CARE, GL_DONT_CARE, 0, nullptr, GL_FALSE);
    glDebugMessageControl(GL_DONT_CARE, GL_DEBUG_TYPE_ERROR, GL_DONT_CARE, 0, nullptr, GL_TRUE);
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    return {};
}

}  // namespace

int Gpu::samplesFor(int asked) const {
    const auto enough = std::lower_bound(sampleCounts.begin(), sampleCounts.end(), asked);
    return enough == sampleCounts.end() ? sampleCounts.back() : *enough;
}

int64_t Gpu::totalBytes() const {
    int64_t sum = 0;
    for (const auto& [owner, bytes] : ledger) sum += bytes;
    return sum;
}

Result<std::unique_ptr<Gpu>> makeHeadlessGpu() {
    auto egl = std::make_shared<EglContext>();
    std::string tried;
    bool made = false;
    for (EGLDeviceEXT device : devicesHardwareFirst()) {
        made = contextOn(eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, device, nullptr), *egl, tried, "EGL device");
        if (made) break;
    }
    if (!made && epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless"))
        made = contextOn(eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr), *egl,
                         tried, "EGL surfaceless");
    if (!made)
        return noContext("no OpenGL 4.5 context without a window (" + tried + "EGL)",
                         "install a driver: libegl1 with libgl1-mesa-dri renders in software");
    auto gpu = std::make_unique<Gpu>();
    gpu->context = egl;
    if (Status s = describe(*gpu); !s) return s.error();
    return gpu;
}

void makeCurrent(const Gpu& gpu) {
    if (const auto egl = std::static_pointer_cast<EglContext>(gpu.context))
        eglMakeCurrent(egl->display, EGL_NO_SURFACE, EGL_NO_SURFACE, egl->context);
}

Result<std::unique_ptr<Gpu>> adoptCurrentGpu() {
    auto gpu = std::make_unique<Gpu>();
    if (Status s = describe(*gpu); !s) return s.error();
    return gpu;
}

void beginDimming() {
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_ONE, GL_SRC1_COLOR, GL_ZERO, GL_ONE);
    glDepthMask(GL_FALSE);
}

// A function that asks for a second colour may not stay, although nothing blends: Mesa refuses every later draw into
// more than one image.
void endDimming() {
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    glBlendFuncSeparate(GL_ONE, GL_ZERO, GL_ONE, GL_ZERO);
}

}  // namespace sward
