// SPDX-License-Identifier: MIT
#include <viz/gl/context/gl_objects.h>

#include <optional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <viz/gl/context/offscreen_context.h>

namespace lightcuts::viz {
namespace {

using ::testing::Each;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

/// A triangle that covers the picture.
constexpr const char* vertex = R"(#version 330 core
void main() {
  vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  gl_Position = vec4(corner, 0.0, 1.0);
})";
constexpr const char* fragment = R"(#version 330 core
uniform vec4 colour;
uniform float rows_from;
out vec4 result;
void main() { result = gl_FragCoord.y > rows_from ? colour : vec4(0.0); })";

std::string message_of(const std::string& vertex_source, const std::string& fragment_source) {
  try {
    const Program program(vertex_source, fragment_source);
  } catch (const GlError& error) {
    return error.what();
  }
  return "";
}

class GlObjects : public ::testing::Test {
protected:
  void TearDown() override { EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR)); }

  OffscreenContext context_;
};

TEST_F(GlObjects, ContextIsCoreOpenGl33) {
  GLint major = 0, minor = 0, profile = 0;
  glGetIntegerv(GL_MAJOR_VERSION, &major);
  glGetIntegerv(GL_MINOR_VERSION, &minor);
  glGetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
  EXPECT_GE(10 * major + minor, 33);
  EXPECT_EQ(profile, GL_CONTEXT_CORE_PROFILE_BIT);
}

TEST(OffscreenContextTest, OneCanFollowAnother) {
  for (int i = 0; i < 3; ++i) {
    const OffscreenContext context;
    EXPECT_GE(Texture2D::max_side(), 1024U);
  }
}

TEST_F(GlObjects, ShaderThatDoesNotCompileIsRefusedWithTheLog) {
  EXPECT_THAT(message_of(vertex, "#version 330 core\nvoid main() { nonsense = 1; }"),
              HasSubstr("nonsense"));
  EXPECT_THAT(message_of("#version 330 core\nin int;", fragment), HasSubstr("vertex shader"));
  EXPECT_EQ(message_of(vertex, fragment), "");
}

TEST_F(GlObjects, UnknownUniformIsRefused) {
  const Program program(vertex, fragment);
  program.set("colour", glm::vec4(1));
  EXPECT_THROW(program.set("color", glm::vec4(1)), GlError);
  EXPECT_THROW(program.bind_block("lights", 0), GlError);
}

TEST_F(GlObjects, ReadsBackWhatWasDrawnFromTheTop) {
  const Program program(vertex, fragment);
  const VertexArray none;
  Framebuffer target({TexelFormat::rgba32f}, true);
  target.resize({5, 4});
  target.bind();
  none.bind();
  program.set("colour", glm::vec4(0.1F, 70000, -3, 1));
  program.set("rows_from", 3.0F); // the top one only
  glDrawArrays(GL_TRIANGLES, 0, 3);
  const std::vector<glm::vec4> pixels = target.read_rgba32f(0);
  ASSERT_EQ(pixels.size(), 20U);
  for (std::size_t i = 0; i < 20; ++i)
    EXPECT_EQ(pixels[i], i < 5 ? glm::vec4(0.1F, 70000, -3, 1) : glm::vec4(0)) << i;
}

TEST_F(GlObjects, FramebufferIsResized) {
  Framebuffer target({TexelFormat::rgba8, TexelFormat::rgba32f}, true);
  EXPECT_TRUE(target.read_rgba8(0).empty());
  for (const glm::uvec2 size : {glm::uvec2(1, 1), glm::uvec2(7, 3), glm::uvec2(64, 128)}) {
    target.resize(size);
    target.bind();
    glClearColor(1, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    EXPECT_EQ(target.read_rgba8(0).size(), std::size_t{size.x} * size.y);
    EXPECT_THAT(target.read_rgba8(0), Each(Rgba8(255, 0, 0, 255)));
    EXPECT_THAT(target.read_rgba32f(1), Each(glm::vec4(1, 0, 0, 1)));
  }
}

TEST_F(GlObjects, SizesThatTheDriverRefusesThrow) {
  Framebuffer target({TexelFormat::rgba8}, false);
  const std::uint32_t too_large = Texture2D::max_side() + 1;
  for (const glm::uvec2 size : {glm::uvec2(0, 4), glm::uvec2(4, too_large)})
    EXPECT_THAT([&] { target.resize(size); }, ThrowsMessage<GlError>(HasSubstr("on a side")));
  target.resize({4, 4});
  EXPECT_EQ(target.size(), glm::uvec2(4, 4));
  Texture2D texture;
  const std::vector<glm::vec3> five(5);
  EXPECT_THROW(texture.upload({2, 2}, five), GlError);
}

TEST_F(GlObjects, DrawScopeRestoresTheTarget) {
  Framebuffer first({TexelFormat::rgba8}, false), second({TexelFormat::rgba8}, false);
  first.resize({3, 3});
  second.resize({5, 2});
  first.bind();
  GLint before = 0, after = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &before);
  {
    const DrawScope scope;
    second.bind();
    glEnable(GL_BLEND);
  }
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &after);
  EXPECT_EQ(before, after);
  EXPECT_FALSE(glIsEnabled(GL_BLEND));
  GLint viewport[4];
  glGetIntegerv(GL_VIEWPORT, viewport);
  EXPECT_EQ(viewport[2], 3);
}

TEST_F(GlObjects, MovedObjectOutlivesItsSource) {
  std::optional<Texture2D> first(std::in_place);
  const GLuint id = first->id();
  std::optional<Texture2D> second(std::move(*first));
  first.reset();
  Texture2D third;
  third = std::move(*second);
  second.reset();
  EXPECT_EQ(third.id(), id);
  third.bind(0);
  EXPECT_TRUE(glIsTexture(id));
}

} // namespace
} // namespace lightcuts::viz
