#include "scene_import/gltf_accessor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "scene_import/scene_import.hpp"

namespace atelier::scene_import {
namespace {

/// glTF's componentType, with OpenGL's numbers.
enum ComponentType { byte = 5120, unsigned_byte, short_, unsigned_short, unsigned_int = 5125, float_ };

std::size_t bytes_of(ComponentType type) {
  switch (type) {
    case byte:
    case unsigned_byte:
      return 1;
    case short_:
    case unsigned_short:
      return 2;
    default:
      return 4;
  }
}

ComponentType component_type(const JsonField& accessor) {
  const JsonField field = accessor.at("componentType");
  const std::int64_t type = field.integer(0, 1 << 16);
  if (type < byte || type > float_ || type == 5124)
    field.fail(fmt::format("{} (allowed: 5120, 5121, 5122, 5123, 5125, 5126)", type));
  return ComponentType(type);
}

int components_of(const JsonField& accessor) {
  const JsonField field = accessor.at("type");
  const std::string& type = field.text();
  if (type == "SCALAR") return 1;
  if (type.size() == 4 && type.starts_with("VEC") && type[3] >= '2' && type[3] <= '4') return type[3] - '0';
  if (type == "MAT4") return 16;  // four columns of four floats: no padding
  field.fail(fmt::format("'{}' (allowed here: SCALAR, VEC2, VEC3, VEC4, MAT4)", type));
}

template <class T>
T value_at(const char* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof value);  // data need not be aligned
  return value;
}

float float_at(const char* bytes, ComponentType type, bool normalized) {
  // Signed integers have one more negative than positive value: it is clamped to -1.
  switch (type) {
    case byte: {
      const auto v = float(value_at<std::int8_t>(bytes));
      return normalized ? std::max(v / 127, -1.0f) : v;
    }
    case unsigned_byte:
      return float(value_at<std::uint8_t>(bytes)) / (normalized ? 255 : 1);
    case short_: {
      const auto v = float(value_at<std::int16_t>(bytes));
      return normalized ? std::max(v / 32767, -1.0f) : v;
    }
    case unsigned_short:
      return float(value_at<std::uint16_t>(bytes)) / (normalized ? 65535 : 1);
    case unsigned_int:
      return float(value_at<std::uint32_t>(bytes));
    default:
      return value_at<float>(bytes);
  }
}

bool is_unsigned(ComponentType type) {
  return type == unsigned_byte || type == unsigned_short || type == unsigned_int;
}

std::uint32_t index_at(const char* bytes, ComponentType type) {
  switch (type) {
    case unsigned_byte:
      return value_at<std::uint8_t>(bytes);
    case unsigned_short:
      return value_at<std::uint16_t>(bytes);
    default:
      return value_at<std::uint32_t>(bytes);
  }
}

/// A range of elements that has been checked to lie inside a view.
struct Run {
  const char* first;
  std::size_t stride;
  const char* element(std::size_t i) const { return first + i * stride; }
};

/// `holder` carries bufferView and byteOffset: an accessor, or a part of a sparse one (which has no stride).
Run find_run(const GltfFile& file, const JsonField& holder, std::size_t count, std::size_t element, bool strided) {
  const int view_index = holder.at("bufferView").index(file.root().size_or_zero("bufferViews"));
  const std::string_view view = view_bytes(file, view_index);
  const auto offset = std::size_t(holder.integer_or("byteOffset", 0, std::int64_t(1) << 40, 0));
  std::size_t stride = element;
  if (strided) {
    const JsonField field = file.root().at("bufferViews")[std::size_t(view_index)];
    stride = std::size_t(field.integer_or("byteStride", 0, 252, 0));
    if (stride == 0) stride = element;
    if (stride < element) field.fail(fmt::format("byteStride {} for elements of {} bytes", stride, element));
  }
  // count - 1 strides and one element; none of the factors is larger than 2^40, and count is below 2^28.
  const std::size_t needed = (count - 1) * stride + element;
  if (offset > view.size() || needed > view.size() - offset)
    holder.fail(fmt::format("{} elements reach to byte {} of a view of {}", count, offset + needed, view.size()));
  return {view.data() + offset, stride};
}

struct Accessor {
  JsonField field;
  std::size_t count;
  ComponentType type;
  int components;
  std::size_t element() const { return bytes_of(type) * std::size_t(components); }
};

Accessor find_accessor(const GltfFile& file, int index) {
  const JsonField field = file.root().at("accessors")[std::size_t(index)];
  return {field, accessor_count(file, index), component_type(field), components_of(field)};
}

void check_components(const Accessor& accessor, int needed) {
  if (accessor.components != needed)
    accessor.field.fail(fmt::format("'{}' has {} components (needed here: {})", accessor.field.at("type").text(),
                                    accessor.components, needed));
}

/// Calls put(element index, bytes) for every element in the file, first the dense ones, then the sparse ones. All
/// others are zeros: an accessor may have no data at all.
template <class Put>
void for_each_element(const GltfFile& file, const Accessor& accessor, const Put& put) {
  const auto sparse = accessor.field.find("sparse");
  if (accessor.field.find("bufferView")) {
    const Run run = find_run(file, accessor.field, accessor.count, accessor.element(), true);
    for (std::size_t i = 0; i < accessor.count; ++i) put(i, run.element(i));
  }
  if (!sparse) return;
  const auto count = std::size_t(sparse->at("count").integer(1, std::int64_t(accessor.count)));
  const JsonField indices = sparse->at("indices");
  const ComponentType type = component_type(indices);
  if (!is_unsigned(type)) indices.fail("componentType must be an unsigned integer");
  const Run places = find_run(file, indices, count, bytes_of(type), false);
  const Run values = find_run(file, sparse->at("values"), count, accessor.element(), false);
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t place = index_at(places.element(i), type);
    if (place >= accessor.count) indices.fail(fmt::format("element {} of {}", place, accessor.count));
    put(place, values.element(i));
  }
}

}  // namespace

std::size_t accessor_count(const GltfFile& file, int index) {
  const JsonField field = file.root().at("accessors")[std::size_t(index)];
  return std::size_t(field.at("count").integer(1, std::int64_t(3 * max_import_triangles)));
}

std::vector<float> read_accessor(const GltfFile& file, int index, int components) {
  const Accessor accessor = find_accessor(file, index);
  check_components(accessor, components);
  const bool normalized = accessor.field.flag_or("normalized", false);
  std::vector<float> values(accessor.count * std::size_t(components), 0.0f);
  for_each_element(file, accessor, [&](std::size_t i, const char* bytes) {
    for (int c = 0; c < components; ++c)
      values[i * std::size_t(components) + std::size_t(c)] =
          float_at(bytes + std::size_t(c) * bytes_of(accessor.type), accessor.type, normalized);
  });
  return values;
}

std::vector<std::uint32_t> read_unsigned_accessor(const GltfFile& file, int index, int components) {
  const Accessor accessor = find_accessor(file, index);
  check_components(accessor, components);
  if (!is_unsigned(accessor.type))
    accessor.field.at("componentType").fail(fmt::format("{} (allowed here: 5121, 5123, 5125)", int(accessor.type)));
  std::vector<std::uint32_t> values(accessor.count * std::size_t(components), 0);
  for_each_element(file, accessor, [&](std::size_t i, const char* bytes) {
    for (int c = 0; c < components; ++c)
      values[i * std::size_t(components) + std::size_t(c)] =
          index_at(bytes + std::size_t(c) * bytes_of(accessor.type), accessor.type);
  });
  return values;
}

std::vector<glm::dmat4> read_matrix_accessor(const GltfFile& file, int index) {
  const Accessor accessor = find_accessor(file, index);
  if (accessor.type != float_)
    accessor.field.at("componentType").fail(fmt::format("{} (allowed here: 5126)", int(accessor.type)));
  const std::vector<float> values = read_accessor(file, index, 16);
  std::vector<glm::dmat4> matrices(accessor.count);
  for (std::size_t i = 0; i < values.size(); ++i) matrices[i / 16][int(i % 16 / 4)][int(i % 4)] = values[i];
  return matrices;
}

std::optional<int> attribute(const GltfFile& file, const JsonField& primitive, const std::string& name,
                             std::size_t count) {
  const auto index = primitive.at("attributes").index_or_none(name.c_str(), file.root().size_or_zero("accessors"));
  if (!index) return {};
  if (accessor_count(file, *index) == count) return index;
  file.notes->add(fmt::format("{}: accessors[{}] ({}) is left out: {} elements for {} positions", file.name, *index,
                              name, accessor_count(file, *index), count));
  return {};
}

}  // namespace atelier::scene_import
