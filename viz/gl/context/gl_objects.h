// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <viz/gl/context/gl_error.h>
#include <viz/gl/context/opengl.h>

namespace lightcuts::viz {

/// An 8-bit colour with opacity.
using Rgba8 = glm::vec<4, std::uint8_t>;

/// Owns the name of one OpenGL object. Made, used and destroyed where its context is current.
template <void (*destroy)(GLuint)>
class GlName {
public:
  explicit GlName(GLuint id) : id_(id) {}
  ~GlName() {
    if (id_ != 0) destroy(id_);
  }
  GlName(GlName&& other) noexcept : id_(std::exchange(other.id_, 0)) {}
  GlName& operator=(GlName&& other) noexcept {
    std::swap(id_, other.id_);
    return *this;
  }
  [[nodiscard]] GLuint id() const { return id_; }

private:
  GLuint id_;
};

namespace detail {
void destroy_program(GLuint id);
void destroy_buffer(GLuint id);
void destroy_vertex_array(GLuint id);
void destroy_texture(GLuint id);
void destroy_framebuffer(GLuint id);
} // namespace detail

/// A vertex and a fragment shader.
class Program {
public:
  /// GLSL sources, `#version` included. Throws GlError with the driver's log where they do not
  /// compile or link.
  Program(const std::string& vertex, const std::string& fragment);

  void use() const;

  /// Sets a uniform and makes the program the used one. Throws GlError where the program uses no
  /// uniform of that name.
  void set(const char* uniform, int value) const;
  void set(const char* uniform, float value) const;
  void set(const char* uniform, const glm::vec2& value) const;
  void set(const char* uniform, const glm::vec3& value) const;
  void set(const char* uniform, const glm::vec4& value) const;
  void set(const char* uniform, const glm::mat4& value) const;

  /// Lets a uniform block read the buffer at this binding point. Throws GlError where the program
  /// uses no block of that name.
  void bind_block(const char* block, GLuint binding) const;

private:
  [[nodiscard]] GLint location(const char* uniform) const;
  GlName<detail::destroy_program> name_;
};

/// Memory of the graphics card: vertices or a uniform block.
class Buffer {
public:
  Buffer();
  /// Replaces the content and leaves the buffer bound to `target`. `usage`: GL_STATIC_DRAW or
  /// another hint.
  template <class T>
  void upload(GLenum target, std::span<const T> data, GLenum usage) {
    upload_bytes(target, std::as_bytes(data), usage);
  }
  [[nodiscard]] GLuint id() const { return name_.id(); }

private:
  void upload_bytes(GLenum target, std::span<const std::byte> data, GLenum usage);
  GlName<detail::destroy_buffer> name_;
};

/// Which vertex attribute comes from where.
class VertexArray {
public:
  VertexArray();
  void bind() const;
  /// Attribute `index`: `components` values of `type` every `stride` bytes from `offset` of
  /// `buffer`. `normalised`: integers are taken as [0, 1] or [-1, 1].
  void attribute(GLuint index, const Buffer& buffer, int components, GLenum type, bool normalised,
                 std::size_t stride, std::size_t offset) const;

private:
  GlName<detail::destroy_vertex_array> name_;
};

/// Channels of a texel and their type. `rgb8` and `rgba8` are read as [0, 1], without any sRGB
/// decoding.
enum class TexelFormat { rgb8, rgba8, rgb32f, rgba32f, depth32f };

/// An image of the graphics card; the first row is the lowest for OpenGL. No mip levels.
class Texture2D {
public:
  /// Nearest texel, clamped at the edge.
  Texture2D();

  /// Both sides >= 1 and at most max_side(); the content is undefined. Throws GlError.
  void allocate(glm::uvec2 size, TexelFormat format);
  /// size.x * size.y texels, row by row. Throws GlError where their number is another one or the
  /// size is out of range.
  void upload(glm::uvec2 size, std::span<const glm::vec<3, std::uint8_t>> texels);
  void upload(glm::uvec2 size, std::span<const Rgba8> texels);
  void upload(glm::uvec2 size, std::span<const glm::vec3> texels);
  void upload(glm::uvec2 size, std::span<const glm::vec4> texels);

  /// `filter`: GL_NEAREST or GL_LINEAR. Default: GL_NEAREST.
  void set_filter(GLint filter) const;
  /// GL_REPEAT, GL_MIRRORED_REPEAT or GL_CLAMP_TO_EDGE. Default: GL_CLAMP_TO_EDGE.
  void set_wrap(GLint u, GLint v) const;

  /// Binds it to texture unit `unit`, which stays the active one.
  void bind(GLuint unit) const;
  [[nodiscard]] GLuint id() const { return name_.id(); }
  [[nodiscard]] glm::uvec2 size() const { return size_; }
  /// The largest side that the driver takes; at least 1024.
  [[nodiscard]] static std::uint32_t max_side();

private:
  void fill(glm::uvec2 size, TexelFormat format, const void* texels);
  GlName<detail::destroy_texture> name_;
  glm::uvec2 size_{0};
};

/// Textures to draw into.
class Framebuffer {
public:
  /// `colours`: one per output of the shader. Without size until resize().
  explicit Framebuffer(std::vector<TexelFormat> colours, bool with_depth);

  /// Does nothing where the size is the same; else the content is undefined. Both sides >= 1.
  /// Throws GlError where the driver refuses.
  void resize(glm::uvec2 size);
  /// Draws go into it; the viewport is all of it. It has a size.
  void bind() const;

  [[nodiscard]] glm::uvec2 size() const { return size_; }
  [[nodiscard]] const Texture2D& colour(std::size_t i) const { return textures_[i]; }

  /// The pixels of colour i (of any format, converted), row by row from the TOP.
  [[nodiscard]] std::vector<Rgba8> read_rgba8(std::size_t i) const;
  [[nodiscard]] std::vector<glm::vec4> read_rgba32f(std::size_t i) const;

private:
  template <class Pixel>
  [[nodiscard]] std::vector<Pixel> read(std::size_t i, GLenum type) const;
  void attach() const;

  GlName<detail::destroy_framebuffer> name_;
  std::vector<TexelFormat> formats_;
  std::vector<Texture2D> textures_;
  Texture2D depth_;
  bool with_depth_;
  glm::uvec2 size_{0};
};

/// From here on drawings cover by their alpha; an opaque picture stays opaque.
void enable_blending();

/// While it lives, draws may go elsewhere; afterwards to where they went before. At both ends
/// blending, depth and scissor tests and culling are off, depths and colours written, and no
/// program, vertex array or buffer of the caller is to be relied on.
class DrawScope {
public:
  DrawScope();
  ~DrawScope();
  DrawScope(const DrawScope&) = delete;
  DrawScope& operator=(const DrawScope&) = delete;

private:
  GLint draw_framebuffer_ = 0, read_framebuffer_ = 0;
  GLint viewport_[4] = {};
};

} // namespace lightcuts::viz
