// SPDX-License-Identifier: MIT
#include <viz/panels/app/window.h>

#include <array>
#include <cstdlib>
#include <memory>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <imgui.h>

#include <viz/gl/context/gl_error.h>
#include <viz/panels/app/app.h>
#include <viz/panels/app/frame_pacer.h>
#include <viz/panels/app/lost_display.h>
#include <viz/panels/gui/gui.h>

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
  WindowHandle window(glfwCreateWindow(int(settings.window_size.x), int(settings.window_size.y),
                                       "Lightcuts", nullptr, nullptr));
  if (!window) throw GlError("no window with OpenGL 3.3: " + Glfw::last_error());
  glfwMakeContextCurrent(window.get());
  glfwSwapInterval(1);
  return window;
}

/// What GLFW's callbacks find by the window's user pointer.
struct Connection {
  App* app = nullptr;
  std::set<int> pressed; ///< keys, since the last frame
  std::vector<std::array<int, 4>> deferred;
};

Connection& connection_of(GLFWwindow* window) {
  return *static_cast<Connection*>(glfwGetWindowUserPointer(window));
}

/// ImGui looks at keys once per frame: what is released in a frame in which something was pressed
/// stays down until the next one.
void pass_key(GLFWwindow* window, int key, int scancode, int action, int mods) {
  Connection& connection = connection_of(window);
  if (action == GLFW_PRESS) connection.pressed.insert(key);
  if (action == GLFW_RELEASE && !connection.pressed.empty()) // in their order
    connection.deferred.push_back({key, scancode, action, mods});
  else
    ImGui_ImplGlfw_KeyCallback(window, key, scancode, action, mods);
}

void release_deferred_keys(GLFWwindow* window) {
  Connection& connection = connection_of(window);
  connection.pressed.clear();
  for (const auto& [key, scancode, action, mods] : connection.deferred)
    ImGui_ImplGlfw_KeyCallback(window, key, scancode, action, mods);
  connection.deferred.clear();
}

/// The window's mouse, keys and dropped files.
class Input {
public:
  Input(GLFWwindow* window, App& app) : connection_{&app, {}, {}} {
    glfwSetWindowUserPointer(window, &connection_);
    ImGui_ImplGlfw_InitForOpenGL(window, true);
    glfwSetKeyCallback(window, pass_key);
    glfwSetDropCallback(window, [](GLFWwindow* at, int count, const char** files) {
      if (count > 0) connection_of(at).app->drop(files[0]);
    });
  }
  ~Input() { ImGui_ImplGlfw_Shutdown(); }
  Input(const Input&) = delete;
  Input& operator=(const Input&) = delete;

private:
  Connection connection_;
};

float scale_of(GLFWwindow* window, const std::optional<float>& wanted) {
  float x = 1, y = 1;
  glfwGetWindowContentScale(window, &x, &y);
  return wanted.value_or(x);
}

void draw(GLFWwindow* window, Gui& gui, App& app, glm::ivec2 size) {
  ImGui_ImplGlfw_NewFrame();
  gui.begin();
  app.frame();
  gui.end(glm::uvec2(size));
  glfwSwapBuffers(window);
  release_deferred_keys(window);
}

/// Until the next frame is due, or something happens. While the pace is the fastest, events wait
/// for the frame.
void wait_for_events(FramePacer& pacer, bool busy) {
  const auto start = Clock::now();
  const double patience = pacer.patience(busy, start);
  if (patience > FramePacer::fastest) {
    glfwWaitEventsTimeout(patience);
  } else {
    std::this_thread::sleep_for(std::chrono::duration<double>(patience));
    glfwPollEvents();
  }
  pacer.waited(patience, seconds_since(start));
}

/// What is to be remembered of the window; asks nobody but the app.
AppSettings settings_of(App& app, glm::ivec2 window_size) {
  AppSettings settings = app.settings();
  settings.window_size = glm::uvec2(window_size);
  return settings;
}

} // namespace

void run_window(const AppSettings& settings, std::optional<float> scale,
                const std::filesystem::path& output, const std::function<void(App&)>& start,
                const std::function<void(const AppSettings&)>& end) {
  const Glfw glfw;
  const WindowHandle window = make_window(settings);
  Gui gui(scale_of(window.get(), scale));
  App app(settings, output);
  const Input input(window.get(), app);
  start(app);
  glm::ivec2 window_size(settings.window_size); // in its last frame
  const LostDisplayGuard guard([&] { end(settings_of(app, window_size)); });
  FramePacer pacer;
  while (glfwWindowShouldClose(window.get()) == GLFW_FALSE && !app.wants_to_quit()) {
    wait_for_events(pacer, !app.settled());
    const auto frame_start = Clock::now();
    glm::ivec2 size(0);
    glfwGetFramebufferSize(window.get(), &size.x, &size.y);
    if (size.x > 0 && size.y > 0) { // else minimised, or made to nothing
      glfwGetWindowSize(window.get(), &window_size.x, &window_size.y);
      draw(window.get(), gui, app, size);
    }
    pacer.drawn(frame_start, Clock::now());
  }
  glfwHideWindow(window.get());
  glfwPollEvents();
  end(settings_of(app, window_size));
  // Reading a file cannot be left, and nobody waits for it.
  if (app.workbench().opening()) std::_Exit(0);
}

} // namespace lightcuts::viz
