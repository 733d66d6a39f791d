#pragma once

#include <EGL/egl.h>

#include <memory>
#include <set>
#include <string>

struct gbm_device;

namespace vitrine::player {

/// An EGL display with one OpenGL ES 3 context, made current without a surface from the start. Thread-bound:
/// its context is current on the thread that made it, until this is destroyed.
class Egl {
  public:
    /// Draws to memory only; works without any device (Mesa's surfaceless platform).
    static Egl surfaceless();

    /// Draws to the buffers of a GBM device, which outlives this.
    static Egl on(gbm_device& device);

    Egl(Egl&& other) noexcept;
    Egl(const Egl&) = delete;
    Egl& operator=(const Egl&) = delete;
    Egl& operator=(Egl&&) = delete;
    ~Egl();

    EGLDisplay display() const { return display_; }

    EGLConfig config() const { return config_; }

    /// Draws to this surface from now on; EGL_NO_SURFACE: to frame buffer objects only.
    void make_current(EGLSurface surface);

  private:
    enum class End { leave, terminate };

    Egl(EGLDisplay display, End end) : display_(display), end_(end) {}

    void create_context(EGLint visual);

    EGLDisplay display_ = EGL_NO_DISPLAY;
    End end_;  // `leave`: the EGL display stays, because another Egl of the process may use it
    EGLConfig config_ = nullptr;
    EGLContext context_ = EGL_NO_CONTEXT;
};

/// GL in software, for cards that leave drawing to the processor. It does not depend on a card. It is kept
/// from one display to the next, because making it and compiling its shaders takes most of the time to the
/// first picture.
struct SoftwareGl {
    std::shared_ptr<Egl> egl;       // shared with the displays and the renderer; none: not made yet
    std::set<std::string> drivers;  // drivers of the cards that used it so far
};

/// @throws std::runtime_error naming `what` was tried, and EGL's error
[[noreturn]] void throw_egl(const char* what);

}  // namespace vitrine::player
