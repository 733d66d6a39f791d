#include "player/display/egl.hpp"

#include "player/display/gl_device.hpp"
#include "player/display/mesa_options.hpp"

#include <EGL/eglext.h>
#include <GLES3/gl3.h>
#include <fmt/format.h>
#include <gbm.h>

#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

namespace vitrine::player {

namespace {

constexpr EGLint any_visual = 0;

std::string error_name(EGLint error) {
    switch (error) {
    case EGL_NOT_INITIALIZED:
        return "EGL_NOT_INITIALIZED";
    case EGL_BAD_ACCESS:
        return "EGL_BAD_ACCESS";
    case EGL_BAD_ALLOC:
        return "EGL_BAD_ALLOC";
    case EGL_BAD_ATTRIBUTE:
        return "EGL_BAD_ATTRIBUTE";
    case EGL_BAD_CONTEXT:
        return "EGL_BAD_CONTEXT";
    case EGL_BAD_CONFIG:
        return "EGL_BAD_CONFIG";
    case EGL_BAD_DISPLAY:
        return "EGL_BAD_DISPLAY";
    case EGL_BAD_SURFACE:
        return "EGL_BAD_SURFACE";
    case EGL_BAD_MATCH:
        return "EGL_BAD_MATCH";
    case EGL_BAD_PARAMETER:
        return "EGL_BAD_PARAMETER";
    case EGL_BAD_NATIVE_PIXMAP:
        return "EGL_BAD_NATIVE_PIXMAP";
    case EGL_BAD_NATIVE_WINDOW:
        return "EGL_BAD_NATIVE_WINDOW";
    case EGL_CONTEXT_LOST:
        return "EGL_CONTEXT_LOST";
    default:
        return fmt::format("EGL error {:#x}", error);
    }
}

EGLDisplay open_display(EGLenum platform, const char* extension, void* device) {
    set_mesa_options();  // for programs that have not done so at their start
    if (!has_word(eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS), extension))
        throw std::runtime_error(fmt::format("EGL has no {}: install Mesa's EGL (libegl-mesa0)", extension));
    const EGLDisplay display = eglGetPlatformDisplay(platform, device, nullptr);
    if (display == EGL_NO_DISPLAY) throw_egl("get an EGL display");
    EGLint major = 0;
    EGLint minor = 0;
    if (!eglInitialize(display, &major, &minor)) throw_egl("initialise EGL");
    return display;
}

// A GBM surface works only with an EGL config of the same format.
EGLConfig choose_config(EGLDisplay display, EGLint visual) {
    const EGLint wanted[] = {EGL_RENDERABLE_TYPE,
                             EGL_OPENGL_ES3_BIT,
                             EGL_SURFACE_TYPE,
                             visual == any_visual ? 0 : EGL_WINDOW_BIT,
                             EGL_RED_SIZE,
                             8,
                             EGL_GREEN_SIZE,
                             8,
                             EGL_BLUE_SIZE,
                             8,
                             EGL_NONE};
    EGLint count = 0;
    if (!eglChooseConfig(display, wanted, nullptr, 0, &count)) throw_egl("list EGL configs");
    std::vector<EGLConfig> configs(static_cast<std::size_t>(count));
    if (!eglChooseConfig(display, wanted, configs.data(), count, &count)) throw_egl("list EGL configs");
    for (EGLConfig config : configs) {
        EGLint id = 0;
        if (visual == any_visual) return config;
        if (eglGetConfigAttrib(display, config, EGL_NATIVE_VISUAL_ID, &id) && id == visual) return config;
    }
    throw std::runtime_error("EGL has no OpenGL ES 3 config with 8 bits a channel for this screen");
}

}  // namespace

void throw_egl(const char* what) {
    throw std::runtime_error(fmt::format("{}: {}", what, error_name(eglGetError())));
}

Egl Egl::surfaceless() {
    Egl egl(open_display(EGL_PLATFORM_SURFACELESS_MESA, "EGL_MESA_platform_surfaceless", EGL_DEFAULT_DISPLAY),
            End::leave);
    egl.create_context(any_visual);
    return egl;
}

Egl Egl::on(gbm_device& device) {
    Egl egl(open_display(EGL_PLATFORM_GBM_KHR, "EGL_KHR_platform_gbm", &device), End::terminate);
    egl.create_context(GBM_FORMAT_XRGB8888);
    return egl;
}

void Egl::create_context(EGLint visual) {
    if (!has_word(eglQueryString(display_, EGL_EXTENSIONS), "EGL_KHR_surfaceless_context"))
        throw std::runtime_error("this EGL cannot draw without a surface (EGL_KHR_surfaceless_context)");
    if (!eglBindAPI(EGL_OPENGL_ES_API)) throw_egl("bind OpenGL ES");
    config_ = choose_config(display_, visual);
    const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_NONE};
    context_ = eglCreateContext(display_, config_, EGL_NO_CONTEXT, version);
    if (context_ == EGL_NO_CONTEXT) throw_egl("create an OpenGL ES 3 context");
    make_current(EGL_NO_SURFACE);
}

Egl::Egl(Egl&& other) noexcept
    : display_(std::exchange(other.display_, EGL_NO_DISPLAY)),
      end_(other.end_),
      config_(std::exchange(other.config_, nullptr)),
      context_(std::exchange(other.context_, EGL_NO_CONTEXT)) {}

Egl::~Egl() {
    if (display_ == EGL_NO_DISPLAY) return;
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (context_ != EGL_NO_CONTEXT) eglDestroyContext(display_, context_);
    if (end_ == End::terminate) eglTerminate(display_);
}

void Egl::make_current(EGLSurface surface) {
    if (!eglMakeCurrent(display_, surface, surface, context_)) throw_egl("make an EGL surface current");
}

}  // namespace vitrine::player
