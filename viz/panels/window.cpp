// SPDX-License-Identifier: MIT
#include "window.h"

#include <cstdlib>
#include <memory>
#include <string>
#include <thread>

#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <imgui.h>

#include "gl/gl_error.h"
#include "panels/app.h"
#include "panels/frame_pacer.h"
#include "panels/gui.h"

namespace lightcuts::viz {
namespace {

/// GLFW, started and ended.
class Glfw {
public:
  Glfw() {
    if (glfwInit() == GLFW_FALSE) throw GlError("no window: " + last_error());
  }
  ~Glfw() { glfwTerminate(); }
  Glfw(const Glfw&) = delete;
  Glfw& operator=(const Glfw&) = delete;

  static std::string last_error() {
    const char* text = nullptr;
    glfwGetError(&text);
    return std::string(text == nullptr ? "unknown reason" : text) +
           " (without a screen, --screenshot FILE draws the window into a picture)";
  }
};

struct DestroyWindow {
  void operator()(GLFWwindow* window) const { glfwDestroyWindow(window); }
};
using WindowHandle = std::unique_ptr<GLFWwindow, DestroyWindow>;

WindowHandle make_window(const AppSettings& settings) {
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  WindowHandle window(glfwCreateWindow(settings.window_size.x, settings.window_size.y, "Lightcuts",
                                       nullptr, nullptr));
  if (!window) throw GlError("no window with OpenGL 3.3: " + Glfw::last_error());
  glfwMakeContextCurrent(window.get());
  glfwSwapInterval(1);
  return window;
}

/// ImGui's connection to the window's mouse and keys.
class Input {
public:
  explicit Input(GLFWwindow* window) { ImGui_ImplGlfw_InitForOpenGL(window, true); }
  ~Input() { ImGui_ImplGlfw_Shutdown(); }
  Input(const Input&) = delete;
  Input& operator=(const Input&) = delete;
};

float scale_of(GLFWwindow* window, const std::optional<float>& wanted) {
  float x = 1, y = 1;
  glfwGetWindowContentScale(window, &x, &y);
  return wanted.value_or(x);
}

void let_files_drop(GLFWwindow* window, App& app) {
  glfwSetWindowUserPointer(window, &app);
  glfwSetDropCallback(window, [](GLFWwindow* at, int count, const char** files) {
    if (count > 0) static_cast<App*>(glfwGetWindowUserPointer(at))->drop(files[0]);
  });
}

void draw(GLFWwindow* window, Gui& gui, App& app, glm::ivec2 size) {
  ImGui_ImplGlfw_NewFrame();
  gui.begin();
  app.frame();
  gui.end(glm::uvec2(size));
  glfwSwapBuffers(window);
}

/// Until the next frame is due, or something happens. While the pace is the fastest, events wait
/// for the frame.
void wait_for_events(FramePacer& pacer, bool busy) {
  const auto start = FramePacer::Clock::now();
  const double patience = pacer.patience(busy, start);
  if (patience > FramePacer::fastest) {
    glfwWaitEventsTimeout(patience);
  } else {
    std::this_thread::sleep_for(std::chrono::duration<double>(patience));
    glfwPollEvents();
  }
  pacer.waited(patience, std::chrono::duration<double>(FramePacer::Clock::now() - start).count());
}

} // namespace

AppSettings run_window(const AppSettings& settings, std::optional<float> scale,
                       const std::filesystem::path& output,
                       const std::function<void(App&)>& start) {
  const Glfw glfw;
  const WindowHandle window = make_window(settings);
  Gui gui(scale_of(window.get(), scale));
  const Input input(window.get());
  App app(settings, output);
  let_files_drop(window.get(), app);
  start(app);
  FramePacer pacer;
  while (glfwWindowShouldClose(window.get()) == GLFW_FALSE && !app.wants_to_quit()) {
    wait_for_events(pacer, !app.settled());
    glm::ivec2 size(0);
    glfwGetFramebufferSize(window.get(), &size.x, &size.y);
    if (size.x > 0 && size.y > 0) // else minimised, or made to nothing
      draw(window.get(), gui, app, size);
    pacer.drawn(FramePacer::Clock::now());
  }
  AppSettings result = app.settings();
  glm::ivec2 size(0);
  glfwGetWindowSize(window.get(), &size.x, &size.y);
  if (size.x > 0 && size.y > 0) result.window_size = size;
  return result;
}

} // namespace lightcuts::viz
