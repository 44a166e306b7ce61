// SPDX-License-Identifier: MIT
#include <lightcuts/render/io/models/gltf/gltf_accessor.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <limits>
#include <string_view>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

namespace lightcuts {
namespace {

static_assert(std::endian::native == std::endian::little); // as glTF's buffers are

/// Elements that no bytes stand behind are zeros; a file could ask for any number of them.
constexpr std::size_t most_zeros = 16'000'000;

std::size_t width_of(const std::string& type) {
  constexpr std::array<std::pair<std::string_view, std::size_t>, 7> widths{{{"SCALAR", 1},
                                                                            {"VEC2", 2},
                                                                            {"VEC3", 3},
                                                                            {"VEC4", 4},
                                                                            {"MAT2", 4},
                                                                            {"MAT3", 9},
                                                                            {"MAT4", 16}}};
  for (const auto& [name, width] : widths)
    if (name == type) return width;
  throw GltfFault(fmt::format("an accessor's type is '{}'", type));
}

/// Calls f with a value of the type that glTF's number stands for.
template <class F>
void with_component(std::size_t type, F&& f) {
  switch (type) {
  case 5120:
    return f(std::int8_t());
  case 5121:
    return f(std::uint8_t());
  case 5122:
    return f(std::int16_t());
  case 5123:
    return f(std::uint16_t());
  case 5125:
    return f(std::uint32_t());
  case 5126:
    return f(float());
  default:
    throw GltfFault(fmt::format("an accessor's componentType is {}", type));
  }
}

/// Where elements lie: the i-th one's bytes begin at i * stride.
struct Layout {
  std::string_view bytes;
  std::size_t stride;
};

/// Refuses elements of `size` bytes that leave the bytes from `offset` on.
Layout layout_of(const GltfFile& file, const gltf::Json& place, std::size_t count, std::size_t size,
                 const std::string& name) {
  const std::size_t index = gltf::whole_in(place, "bufferView");
  const std::string_view view = file.view(index);
  const std::size_t offset = gltf::whole_in(place, "byteOffset", 0);
  const std::size_t stride = gltf::whole_in(file.item("bufferViews", index), "byteStride", size);
  if (stride < size)
    throw GltfFault(fmt::format("{}: a byteStride of {} for {} bytes", name, stride, size));
  if (count > 0 && (offset > view.size() || size > view.size() - offset ||
                    (count - 1) > (view.size() - offset - size) / stride))
    throw GltfFault(fmt::format("{}: {} elements exceed bufferView {}", name, count, index));
  return {view.substr(std::min(offset, view.size())), stride};
}

template <class Component>
Component component_at(const char* at) {
  Component value;
  std::memcpy(&value, at, sizeof value);
  return value;
}

template <class Component>
float number_of(Component value, bool normalized) {
  if constexpr (std::is_floating_point_v<Component>) {
    return value;
  } else {
    if (!normalized) return static_cast<float>(value);
    constexpr double most = std::numeric_limits<Component>::max();
    return static_cast<float>(std::max(value / most, -1.0));
  }
}

class AccessorReader {
public:
  AccessorReader(const GltfFile& file, std::size_t index)
      : file_(file), accessor_(file.item("accessors", index)),
        name_(fmt::format("accessor {}", index)), type_(gltf::whole_in(accessor_, "componentType")),
        width_(width_of(gltf::text_in(accessor_, "type", ""))),
        count_(gltf::whole_in(accessor_, "count")) {}

  [[nodiscard]] std::size_t width() const { return width_; }
  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] const std::string& name() const { return name_; }

  /// convert(Component) makes a Value of each number.
  template <class Value, class Convert>
  std::vector<Value> read(const Convert& convert) const {
    std::vector<Value> values;
    with_component(type_, [&]<class Component>(Component) {
      if (accessor_.contains("bufferView")) {
        const Layout layout =
            layout_of(file_, accessor_, count_, row_size(sizeof(Component)), name_);
        values.resize(count_ * width_);
        for (std::size_t i = 0; i < count_; ++i)
          copy<Component>(layout.bytes.data() + i * layout.stride, &values[i * width_], convert);
      } else {
        if (count_ > most_zeros) throw GltfFault(fmt::format("{}: {} zeros", name_, count_));
        values.resize(count_ * width_);
      }
      if (accessor_.contains("sparse")) replace<Component>(values, convert);
    });
    return values;
  }

private:
  /// Columns of matrices begin at multiples of four bytes.
  [[nodiscard]] std::size_t row_size(std::size_t component) const {
    if (width_ == 9 && component < 4) return 3 * column(3 * component);
    if (width_ == 4 && component == 1 && gltf::text_in(accessor_, "type", "") == "MAT2")
      return 2 * column(2);
    return width_ * component;
  }
  static std::size_t column(std::size_t size) { return (size + 3) / 4 * 4; }

  template <class Component, class Value, class Convert>
  void copy(const char* from, Value* to, const Convert& convert) const {
    const std::size_t row = row_size(sizeof(Component)), rows = width_ == 9 ? 3 : 2;
    const bool padded = row != width_ * sizeof(Component);
    for (std::size_t k = 0; k < width_; ++k) {
      const std::size_t per_row = width_ / rows;
      const std::size_t at = padded ? k / per_row * (row / rows) + k % per_row * sizeof(Component)
                                    : k * sizeof(Component);
      to[k] = convert(component_at<Component>(from + at));
    }
  }

  template <class Component, class Value, class Convert>
  void replace(std::vector<Value>& values, const Convert& convert) const {
    const gltf::Json& sparse = gltf::object_in(accessor_, "sparse");
    const std::size_t count = gltf::whole_in(sparse, "count");
    const gltf::Json& indices = gltf::object_in(sparse, "indices");
    const Layout to = layout_of(file_, gltf::object_in(sparse, "values"), count,
                                row_size(sizeof(Component)), name_);
    with_component(gltf::whole_in(indices, "componentType"), [&]<class Index>(Index) {
      const Layout from = layout_of(file_, indices, count, sizeof(Index), name_);
      for (std::size_t k = 0; k < count; ++k) {
        const Index index = component_at<Index>(from.bytes.data() + k * from.stride);
        if (!(index >= 0 && static_cast<double>(index) < static_cast<double>(count_)))
          throw GltfFault(fmt::format("{}: a sparse index is out of range", name_));
        copy<Component>(to.bytes.data() + k * to.stride,
                        &values[static_cast<std::size_t>(index) * width_], convert);
      }
    });
  }

  const GltfFile& file_;
  const gltf::Json& accessor_;
  std::string name_;
  std::size_t type_, width_, count_;
};

} // namespace

GltfElements read_elements(const GltfFile& file, std::size_t accessor, std::size_t least,
                           std::size_t most) {
  const AccessorReader reader(file, accessor);
  if (reader.width() < least || reader.width() > most)
    throw GltfFault(fmt::format("{}: {} numbers per element, expected {}", reader.name(),
                                reader.width(), least));
  const bool normalized = gltf::truth_in(file.item("accessors", accessor), "normalized", false);
  return {reader.count(), reader.width(),
          reader.read<float>([&](auto value) { return number_of(value, normalized); })};
}

std::vector<std::uint32_t> read_indices(const GltfFile& file, std::size_t accessor) {
  const AccessorReader reader(file, accessor);
  const std::size_t type = gltf::whole_in(file.item("accessors", accessor), "componentType");
  if (reader.width() != 1 || (type != 5121 && type != 5123 && type != 5125))
    throw GltfFault(fmt::format("{}: not unsigned integers", reader.name()));
  return reader.read<std::uint32_t>([](auto value) { return static_cast<std::uint32_t>(value); });
}

} // namespace lightcuts
