// SPDX-License-Identifier: MIT
#pragma once

namespace lightcuts::viz {

/// An OpenGL 3.3 core context without a window, a screen or an X server: EGL on Mesa's surfaceless
/// platform. There is nothing to draw into but framebuffer objects.
class OffscreenContext {
public:
  /// Makes the context current in the calling thread. Throws GlError where there is no EGL, no
  /// surfaceless platform or no OpenGL 3.3.
  OffscreenContext();
  /// Must run in the thread of the constructor, after all objects of the context are gone.
  ~OffscreenContext();
  OffscreenContext(const OffscreenContext&) = delete;
  OffscreenContext& operator=(const OffscreenContext&) = delete;

private:
  void* display_; // EGLDisplay: EGL's headers stay out of here, as they may include X's
  void* context_; // EGLContext
};

} // namespace lightcuts::viz
