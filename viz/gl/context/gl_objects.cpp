// SPDX-License-Identifier: MIT
#include <viz/gl/context/gl_objects.h>

#include <algorithm>
#include <bit>

#include <fmt/format.h>
#include <glm/gtc/type_ptr.hpp>

namespace lightcuts::viz {
namespace detail {

void destroy_program(GLuint id) { glDeleteProgram(id); }
void destroy_buffer(GLuint id) { glDeleteBuffers(1, &id); }
void destroy_vertex_array(GLuint id) { glDeleteVertexArrays(1, &id); }
void destroy_texture(GLuint id) { glDeleteTextures(1, &id); }
void destroy_framebuffer(GLuint id) { glDeleteFramebuffers(1, &id); }

} // namespace detail

namespace {

void destroy_shader(GLuint id) { glDeleteShader(id); }
using Shader = GlName<destroy_shader>;

template <class Generate>
GLuint generated(Generate generate) {
  GLuint id = 0;
  generate(1, &id);
  return id;
}

template <class Get, class GetLog>
void require_status(GLuint id, GLenum status, Get get, GetLog get_log, const char* what) {
  GLint good = 0;
  get(id, status, &good);
  if (good != 0) return;
  std::string log(4096, '\0');
  GLsizei length = 0;
  get_log(id, GLsizei(log.size()), &length, log.data());
  log.resize(std::size_t(length));
  throw GlError(fmt::format("the driver refuses {}: {}", what, log));
}

Shader compiled(GLenum kind, const std::string& source, const char* what) {
  Shader shader(glCreateShader(kind));
  const char* text = source.c_str();
  glShaderSource(shader.id(), 1, &text, nullptr);
  glCompileShader(shader.id());
  require_status(shader.id(), GL_COMPILE_STATUS, glGetShaderiv, glGetShaderInfoLog, what);
  return shader;
}

/// What glTexImage2D wants to know of a format.
struct Layout {
  GLint internal;
  GLenum components, type;
};

Layout layout_of(TexelFormat format) {
  switch (format) {
  case TexelFormat::rgb8:
    return {GL_RGB8, GL_RGB, GL_UNSIGNED_BYTE};
  case TexelFormat::rgba8:
    return {GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE};
  case TexelFormat::rgb32f:
    return {GL_RGB32F, GL_RGB, GL_FLOAT};
  case TexelFormat::rgba32f:
    return {GL_RGBA32F, GL_RGBA, GL_FLOAT};
  case TexelFormat::depth32f:
    break;
  }
  return {GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT};
}

void require_texels(glm::uvec2 size, std::size_t count) {
  if (count != std::size_t{size.x} * size.y)
    throw GlError(fmt::format("{} texels for a texture of {} x {}", count, size.x, size.y));
}

template <class Pixel>
void flip_rows(std::vector<Pixel>& pixels, glm::uvec2 size) {
  for (std::size_t y = 0; y < size.y / 2; ++y) {
    const auto upper = pixels.begin() + std::ptrdiff_t(y * size.x);
    std::swap_ranges(upper, upper + size.x, pixels.end() - std::ptrdiff_t((y + 1) * size.x));
  }
}

void reset_state() {
  for (const GLenum test : {GL_BLEND, GL_DEPTH_TEST, GL_SCISSOR_TEST, GL_STENCIL_TEST, GL_CULL_FACE,
                            GL_PROGRAM_POINT_SIZE})
    glDisable(test);
  glDepthMask(GL_TRUE);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

} // namespace

Program::Program(const std::string& vertex, const std::string& fragment)
    : name_(glCreateProgram()) {
  const Shader first = compiled(GL_VERTEX_SHADER, vertex, "a vertex shader");
  const Shader second = compiled(GL_FRAGMENT_SHADER, fragment, "a fragment shader");
  const GLuint id = name_.id();
  glAttachShader(id, first.id());
  glAttachShader(id, second.id());
  glLinkProgram(id);
  glDetachShader(id, first.id());
  glDetachShader(id, second.id());
  require_status(id, GL_LINK_STATUS, glGetProgramiv, glGetProgramInfoLog, "a pair of shaders");
}

void Program::use() const { glUseProgram(name_.id()); }

GLint Program::location(const char* uniform) const {
  const GLint location = glGetUniformLocation(name_.id(), uniform);
  if (location < 0) throw GlError(fmt::format("a shader uses no uniform '{}'", uniform));
  use();
  return location;
}

void Program::set(const char* uniform, int v) const { glUniform1i(location(uniform), v); }
void Program::set(const char* uniform, float v) const { glUniform1f(location(uniform), v); }
void Program::set(const char* uniform, const glm::vec2& v) const {
  glUniform2fv(location(uniform), 1, glm::value_ptr(v));
}
void Program::set(const char* uniform, const glm::vec3& v) const {
  glUniform3fv(location(uniform), 1, glm::value_ptr(v));
}
void Program::set(const char* uniform, const glm::vec4& v) const {
  glUniform4fv(location(uniform), 1, glm::value_ptr(v));
}
void Program::set(const char* uniform, const glm::mat4& v) const {
  glUniformMatrix4fv(location(uniform), 1, GL_FALSE, glm::value_ptr(v));
}

void Program::bind_block(const char* block, GLuint binding) const {
  const GLuint index = glGetUniformBlockIndex(name_.id(), block);
  if (index == GL_INVALID_INDEX) throw GlError(fmt::format("a shader uses no block '{}'", block));
  glUniformBlockBinding(name_.id(), index, binding);
}

Buffer::Buffer() : name_(generated(glGenBuffers)) {}

void Buffer::upload_bytes(GLenum target, std::span<const std::byte> data, GLenum usage) {
  glBindBuffer(target, name_.id());
  glBufferData(target, GLsizeiptr(data.size()), data.data(), usage);
}

VertexArray::VertexArray() : name_(generated(glGenVertexArrays)) {}

void VertexArray::bind() const { glBindVertexArray(name_.id()); }

void VertexArray::attribute(GLuint index, const Buffer& buffer, int components, GLenum type,
                            bool normalised, std::size_t stride, std::size_t offset) const {
  bind();
  glBindBuffer(GL_ARRAY_BUFFER, buffer.id());
  glEnableVertexAttribArray(index);
  glVertexAttribPointer(index, components, type, normalised ? GL_TRUE : GL_FALSE, GLsizei(stride),
                        std::bit_cast<const void*>(offset)); // OpenGL's way to pass an offset
}

Texture2D::Texture2D() : name_(generated(glGenTextures)) {
  set_filter(GL_NEAREST);
  set_wrap(GL_CLAMP_TO_EDGE, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
}

void Texture2D::fill(glm::uvec2 size, TexelFormat format, const void* texels) {
  const std::uint32_t most = max_side();
  if (size.x < 1 || size.y < 1 || size.x > most || size.y > most)
    throw GlError(fmt::format("a picture of {} x {} pixels: the driver takes 1 to {} on a side",
                              size.x, size.y, most));
  const Layout layout = layout_of(format);
  bind(0);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
  glTexImage2D(GL_TEXTURE_2D, 0, layout.internal, GLsizei(size.x), GLsizei(size.y), 0,
               layout.components, layout.type, texels);
  if (glGetError() == GL_OUT_OF_MEMORY)
    throw GlError(fmt::format("no graphics memory for {} x {} pixels", size.x, size.y));
  size_ = size;
}

void Texture2D::allocate(glm::uvec2 size, TexelFormat format) { fill(size, format, nullptr); }

void Texture2D::upload(glm::uvec2 size, std::span<const glm::vec<3, std::uint8_t>> texels) {
  require_texels(size, texels.size());
  fill(size, TexelFormat::rgb8, texels.data());
}
void Texture2D::upload(glm::uvec2 size, std::span<const Rgba8> texels) {
  require_texels(size, texels.size());
  fill(size, TexelFormat::rgba8, texels.data());
}
void Texture2D::upload(glm::uvec2 size, std::span<const glm::vec3> texels) {
  require_texels(size, texels.size());
  fill(size, TexelFormat::rgb32f, texels.data());
}
void Texture2D::upload(glm::uvec2 size, std::span<const glm::vec4> texels) {
  require_texels(size, texels.size());
  fill(size, TexelFormat::rgba32f, texels.data());
}

void Texture2D::set_filter(GLint filter) const {
  bind(0);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
}

void Texture2D::set_wrap(GLint u, GLint v) const {
  bind(0);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, u);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, v);
}

void Texture2D::bind(GLuint unit) const {
  glActiveTexture(GL_TEXTURE0 + unit);
  glBindTexture(GL_TEXTURE_2D, name_.id());
}

std::uint32_t Texture2D::max_side() {
  GLint side = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &side);
  return std::uint32_t(side);
}

Framebuffer::Framebuffer(std::vector<TexelFormat> colours, bool with_depth)
    : name_(generated(glGenFramebuffers)), formats_(std::move(colours)), textures_(formats_.size()),
      with_depth_(with_depth) {}

void Framebuffer::resize(glm::uvec2 size) {
  if (size == size_) return;
  size_ = glm::uvec2(0); // whatever throws, the old content is gone
  for (std::size_t i = 0; i < formats_.size(); ++i) textures_[i].allocate(size, formats_[i]);
  if (with_depth_) depth_.allocate(size, TexelFormat::depth32f);
  const DrawScope scope;
  attach();
  const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
  if (status != GL_FRAMEBUFFER_COMPLETE)
    throw GlError(fmt::format("the driver cannot draw into such a picture (status {:#06x})",
                              unsigned(status)));
  size_ = size;
}

void Framebuffer::attach() const {
  glBindFramebuffer(GL_FRAMEBUFFER, name_.id());
  std::vector<GLenum> outputs;
  for (std::size_t i = 0; i < textures_.size(); ++i) {
    outputs.push_back(GL_COLOR_ATTACHMENT0 + GLenum(i));
    glFramebufferTexture2D(GL_FRAMEBUFFER, outputs.back(), GL_TEXTURE_2D, textures_[i].id(), 0);
  }
  glDrawBuffers(GLsizei(outputs.size()), outputs.data());
  if (with_depth_)
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth_.id(), 0);
}

void Framebuffer::bind() const {
  glBindFramebuffer(GL_FRAMEBUFFER, name_.id());
  glViewport(0, 0, GLsizei(size_.x), GLsizei(size_.y));
}

template <class Pixel>
std::vector<Pixel> Framebuffer::read(std::size_t i, GLenum type) const {
  std::vector<Pixel> pixels(std::size_t{size_.x} * size_.y);
  if (pixels.empty()) return pixels;
  const DrawScope scope;
  glBindFramebuffer(GL_READ_FRAMEBUFFER, name_.id());
  glReadBuffer(GL_COLOR_ATTACHMENT0 + GLenum(i));
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, GLsizei(size_.x), GLsizei(size_.y), GL_RGBA, type, pixels.data());
  flip_rows(pixels, size_);
  return pixels;
}

std::vector<Rgba8> Framebuffer::read_rgba8(std::size_t i) const {
  return read<Rgba8>(i, GL_UNSIGNED_BYTE);
}
std::vector<glm::vec4> Framebuffer::read_rgba32f(std::size_t i) const {
  return read<glm::vec4>(i, GL_FLOAT);
}

void enable_blending() {
  glEnable(GL_BLEND);
  glBlendEquation(GL_FUNC_ADD);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
}

DrawScope::DrawScope() {
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &draw_framebuffer_);
  glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &read_framebuffer_);
  glGetIntegerv(GL_VIEWPORT, viewport_);
  reset_state();
}

DrawScope::~DrawScope() {
  reset_state();
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, GLuint(draw_framebuffer_));
  glBindFramebuffer(GL_READ_FRAMEBUFFER, GLuint(read_framebuffer_));
  glViewport(viewport_[0], viewport_[1], viewport_[2], viewport_[3]);
}

} // namespace lightcuts::viz
