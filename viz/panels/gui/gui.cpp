// SPDX-License-Identifier: MIT
#include <viz/panels/gui/gui.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <string>
#include <utility>

#include <GLFW/glfw3.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <viz/gl/context/gl_error.h>
#include <viz/gl/context/opengl.h>

namespace lightcuts::viz {
namespace {

constexpr float font_size = 14;

/// A font of Debian's fonts-dejavu-core; elsewhere ImGui's own, which is small but always there.
void add_font(const std::string& name, float scale) {
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  for (const std::string folder :
       {"/usr/share/fonts/truetype/dejavu/", "/usr/share/fonts/dejavu/", "/usr/share/fonts/TTF/"})
    if (const std::string file = folder + name + ".ttf"; std::filesystem::exists(file))
      if (atlas.AddFontFromFileTTF(file.c_str(), std::round(font_size * scale)) != nullptr) return;
  ImFontConfig config;
  config.SizePixels = std::round(13 * scale);
  atlas.AddFontDefault(&config);
}

void set_style(float scale) {
  ImGui::StyleColorsDark();
  ImGuiStyle& style = ImGui::GetStyle();
  style.WindowPadding = {6, 6};
  style.FramePadding = {5, 3};
  style.ItemSpacing = {8, 4};
  style.FrameRounding = 3;
  style.GrabRounding = 3;
  style.WindowBorderSize = 1;
  style.Colors[ImGuiCol_WindowBg] = {0.085F, 0.087F, 0.1F, 1};
  style.Colors[ImGuiCol_PopupBg] = {0.11F, 0.113F, 0.13F, 0.98F};
  style.Colors[ImGuiCol_MenuBarBg] = {0.13F, 0.135F, 0.16F, 1};
  style.ScaleAllSizes(scale);
}

/// As ImGui's GLFW backend maps them, so that a key is the same with and without a window.
void map_keys(ImGuiIO& io) {
  const std::array<std::pair<ImGuiKey, int>, 22> keys{{{ImGuiKey_Tab, GLFW_KEY_TAB},
                                                       {ImGuiKey_LeftArrow, GLFW_KEY_LEFT},
                                                       {ImGuiKey_RightArrow, GLFW_KEY_RIGHT},
                                                       {ImGuiKey_UpArrow, GLFW_KEY_UP},
                                                       {ImGuiKey_DownArrow, GLFW_KEY_DOWN},
                                                       {ImGuiKey_PageUp, GLFW_KEY_PAGE_UP},
                                                       {ImGuiKey_PageDown, GLFW_KEY_PAGE_DOWN},
                                                       {ImGuiKey_Home, GLFW_KEY_HOME},
                                                       {ImGuiKey_End, GLFW_KEY_END},
                                                       {ImGuiKey_Insert, GLFW_KEY_INSERT},
                                                       {ImGuiKey_Delete, GLFW_KEY_DELETE},
                                                       {ImGuiKey_Backspace, GLFW_KEY_BACKSPACE},
                                                       {ImGuiKey_Space, GLFW_KEY_SPACE},
                                                       {ImGuiKey_Enter, GLFW_KEY_ENTER},
                                                       {ImGuiKey_Escape, GLFW_KEY_ESCAPE},
                                                       {ImGuiKey_KeyPadEnter, GLFW_KEY_KP_ENTER},
                                                       {ImGuiKey_A, GLFW_KEY_A},
                                                       {ImGuiKey_C, GLFW_KEY_C},
                                                       {ImGuiKey_V, GLFW_KEY_V},
                                                       {ImGuiKey_X, GLFW_KEY_X},
                                                       {ImGuiKey_Y, GLFW_KEY_Y},
                                                       {ImGuiKey_Z, GLFW_KEY_Z}}};
  for (const auto& [key, code] : keys) io.KeyMap[key] = code;
}

} // namespace

Gui::Gui(float scale) {
  IMGUI_CHECKVERSION();
  context_ = ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr; // the layout is ours: see AppSettings
  map_keys(io);
  set_style(scale);
  add_font("DejaVuSans", scale);
  add_font("DejaVuSansMono", 0.9F * scale); // the second: see push_fixed_width()
  if (!ImGui_ImplOpenGL3_Init("#version 330")) {
    ImGui::DestroyContext(context_);
    throw GlError("ImGui cannot draw by this OpenGL");
  }
}

Gui::~Gui() {
  ImGui::SetCurrentContext(context_);
  ImGui_ImplOpenGL3_Shutdown();
  ImGui::DestroyContext(context_);
}

void push_fixed_width() { ImGui::PushFont(ImGui::GetIO().Fonts->Fonts[1]); }

void Gui::set_screen(glm::uvec2 size, float seconds) {
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = {float(size.x), float(size.y)};
  io.DeltaTime = seconds;
}

void Gui::begin() {
  ImGui_ImplOpenGL3_NewFrame();
  ImGui::NewFrame();
}

void Gui::end(glm::uvec2 size) {
  ImGui::Render();
  glViewport(0, 0, GLsizei(size.x), GLsizei(size.y));
  glDisable(GL_SCISSOR_TEST);
  glClearColor(0.06F, 0.06F, 0.07F, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

} // namespace lightcuts::viz
