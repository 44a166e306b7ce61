// SPDX-License-Identifier: MIT
#include <viz/gl/context/offscreen_context.h>

#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <fmt/format.h>

#include <viz/gl/context/gl_error.h>

namespace lightcuts::viz {
namespace {

[[noreturn]] void refuse(const char* what) {
  throw GlError(fmt::format("no OpenGL without a screen: {} (EGL error {:#06x})", what,
                            unsigned(eglGetError())));
}

EGLDisplay surfaceless_display() {
  const EGLDisplay display =
      eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (display == EGL_NO_DISPLAY) refuse("EGL has no surfaceless platform");
  if (!eglInitialize(display, nullptr, nullptr)) refuse("EGL does not start");
  if (!eglBindAPI(EGL_OPENGL_API)) refuse("EGL offers no desktop OpenGL");
  return display;
}

EGLContext core_context(EGLDisplay display) {
  constexpr EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                   3,
                                   EGL_CONTEXT_MINOR_VERSION,
                                   3,
                                   EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                   EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                   EGL_NONE};
  const EGLContext context =
      eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
  if (context == EGL_NO_CONTEXT) refuse("the driver has no OpenGL 3.3 core context");
  return context;
}

} // namespace

// The display is the process's: other contexts may use it, so that it is never terminated.
OffscreenContext::OffscreenContext()
    : display_(surfaceless_display()), context_(core_context(display_)) {
  if (eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_)) return;
  eglDestroyContext(display_, context_);
  refuse("the OpenGL context cannot be used");
}

OffscreenContext::~OffscreenContext() {
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(display_, context_);
}

} // namespace lightcuts::viz
