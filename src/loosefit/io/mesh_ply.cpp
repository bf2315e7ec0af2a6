#include "loosefit/io/mesh_ply.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <limits>
#include <utility>

#include "loosefit/base/text.h"
#include "loosefit/io/polygon_fan.h"
#include "loosefit/io/text_lines.h"

namespace loosefit::io {
namespace {

constexpr double kMostCorners = 1000, kMostOfStrips = 1e8;  // entries of a list

enum class Kind { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

struct Property {
  std::string name;
  Kind kind = Kind::float32;
  bool list = false;
  Kind count_kind = Kind::uint8;
};

struct Element {
  std::string name;
  std::size_t count = 0;
  std::vector<Property> properties;
};

struct Header {
  bool binary = false;
  bool big = false;  ///< numbers begin with their high byte
  std::vector<Element> elements;
};

Kind kind_of(const TextLines& lines, std::string_view word) {
  static const std::array<std::pair<const char*, Kind>, 16> kNames = {{{"char", Kind::int8},
                                                                       {"int8", Kind::int8},
                                                                       {"uchar", Kind::uint8},
                                                                       {"uint8", Kind::uint8},
                                                                       {"short", Kind::int16},
                                                                       {"int16", Kind::int16},
                                                                       {"ushort", Kind::uint16},
                                                                       {"uint16", Kind::uint16},
                                                                       {"int", Kind::int32},
                                                                       {"int32", Kind::int32},
                                                                       {"uint", Kind::uint32},
                                                                       {"uint32", Kind::uint32},
                                                                       {"float", Kind::float32},
                                                                       {"float32", Kind::float32},
                                                                       {"double", Kind::float64},
                                                                       {"float64", Kind::float64}}};
  for (const auto& [name, kind] : kNames) {
    if (word == name) return kind;
  }
  lines.fail("type \"" + printable(std::string(word)) + "\"", "a PLY number type");
}

Header read_header(TextLines& lines) {
  Header header;
  bool has_format = false;
  while (lines.next()) {
    const auto words = lines.words();
    if (lines.at_end() && (words.empty() || words[0] != "end_header"))
      lines.fail_cut_off("in its head", "end_header");
    if (words.empty() || words[0] == "comment" || words[0] == "obj_info" || words[0] == "ply")
      continue;
    if (words[0] == "end_header") {
      if (!has_format) lines.fail("no format line", "format ascii or binary_little_endian");
      return header;
    }
    // One kind of line after the other; properties belong to the element above them.
    if (words[0] == "format" && words.size() >= 2) {
      has_format = true;
      header.big = words[1] == "binary_big_endian";
      header.binary = header.big || words[1] == "binary_little_endian";
      if (!header.binary && words[1] != "ascii") {
        lines.fail("format " + printable(std::string(words[1])),
                   "ascii, binary_little_endian or binary_big_endian");
      }
    } else if (words[0] == "element" && words.size() == 3) {
      const long count = lines.integer_of(words[2]);
      if (count < 0 || count > 100'000'000) lines.fail(std::string(words[2]), "a count up to 1e8");
      header.elements.push_back({std::string(words[1]), std::size_t(count), {}});
    } else if (words[0] == "property" && !header.elements.empty() && words.size() == 3) {
      header.elements.back().properties.push_back(
          {std::string(words[2]), kind_of(lines, words[1]), false, Kind::uint8});
    } else if (words[0] == "property" && !header.elements.empty() && words.size() == 5 &&
               words[1] == "list") {
      header.elements.back().properties.push_back(
          {std::string(words[4]), kind_of(lines, words[3]), true, kind_of(lines, words[2])});
    } else {
      lines.fail("\"" + printable(std::string(words[0])) + "\"", "a PLY header line");
    }
  }
  lines.fail_cut_off("in its head", "end_header");
}

std::string format_of(const Header& header) {
  return !header.binary ? "ascii" : header.big ? "binary_big_endian" : "binary_little_endian";
}

bool is_control(char c) {
  const auto u = static_cast<unsigned char>(c);
  return u < 0x20 && c != '\t' && c != '\n' && c != '\r';
}

/// The head and the body of a file may be of different writers.
void check_format(const TextLines& lines, std::string_view bytes, const Header& header) {
  const std::string_view some = bytes.substr(lines.offset(), 1000);
  if (some.empty() || header.elements.empty() || header.elements[0].count == 0) return;
  if (!header.binary && std::any_of(some.begin(), some.end(), is_control))
    lines.fail("binary data behind end_header", "text, as its head says: format ascii",
               "its format line is wrong, or the file was put together from two");
  const bool text = std::all_of(some.begin(), some.end(), [](char c) {
    return (c >= '0' && c <= '9') || std::string_view(" \t\r\n.,+-eE").find(c) != std::string::npos;
  });
  if (header.binary && text && some.size() >= 8)
    lines.fail("numbers as text behind end_header",
               "binary data, as its head says: format " + format_of(header),
               "its format line is wrong: text is `format ascii 1.0`");
}

/// Hands out the numbers of the body one by one, from text or bytes.
class Values {
 public:
  Values(TextLines& lines, std::string_view bytes, const Header& header)
      : lines_(lines), bytes_(bytes), at_(lines.offset()), header_(header) {}

  /// What is read now, for messages.
  void at(const Element& element, std::size_t item) { element_ = &element, item_ = item; }

  double next(Kind kind) {
    if (!header_.binary) return next_word();
    switch (kind) {
      case Kind::int8:
        return take<std::int8_t>();
      case Kind::uint8:
        return take<std::uint8_t>();
      case Kind::int16:
        return take<std::int16_t>();
      case Kind::uint16:
        return take<std::uint16_t>();
      case Kind::int32:
        return take<std::int32_t>();
      case Kind::uint32:
        return take<std::uint32_t>();
      case Kind::float32:
        return take<float>();
      case Kind::float64:
        return take<double>();
    }
    return 0;
  }

 private:
  template <class T>
  double take() {
    if (bytes_.size() - at_ < sizeof(T)) cut_off();
    std::array<char, sizeof(T)> raw;
    std::memcpy(raw.data(), bytes_.data() + at_, sizeof(T));
    if (header_.big) std::reverse(raw.begin(), raw.end());
    T value;
    std::memcpy(&value, raw.data(), sizeof(T));
    at_ += sizeof(T);
    return double(value);
  }
  double next_word() {
    while (word_ >= words_.size()) {
      if (!lines_.next()) cut_off();
      words_ = lines_.words();
      word_ = 0;
    }
    return lines_.number_of(words_[word_++]);
  }

  [[noreturn]] void cut_off() const {
    lines_.fail_cut_off("in " + element_->name + " " + std::to_string(item_ + 1) + " of " +
                            std::to_string(element_->count),
                        "as many as its head says");
  }

  TextLines& lines_;
  std::string_view bytes_;
  std::size_t at_;
  const Element* element_ = nullptr;
  std::size_t item_ = 0;
  const Header& header_;
  std::vector<std::string_view> words_;
  std::size_t word_ = 0;
};

void check_coordinate(const TextLines& lines, double value) {
  if (!(value > -1e9 && value < 1e9)) lines.fail("a coordinate that is not finite", "a number");
}

void read_face(const TextLines& lines, const std::vector<double>& written, std::size_t vertex_count,
               geometry::TriangleMesh& mesh) {
  std::vector<int> corners;
  for (const double index : written) {
    if (!(index >= 0 && index < double(vertex_count)) || index != double(int(index))) {
      lines.fail("a face with vertex " + shortest(index),
                 "vertices from 0 to " + std::to_string(vertex_count) + " - 1",
                 "is the format line right (text, low or high byte first), and the file whole?");
    }
    corners.push_back(int(index));
  }
  add_polygon(corners, mesh);
}

/// Strips of triangles one after the other, each ended by a −1; every second triangle of a strip
/// runs the other way round.
void read_strips(const TextLines& lines, const std::vector<double>& written,
                 std::size_t vertex_count, geometry::TriangleMesh& mesh) {
  std::size_t from = 0;
  for (std::size_t k = 0; k < written.size(); ++k) {
    if (written[k] == -1) {
      from = k + 1;
    } else if (k >= from + 2) {
      std::vector<double> corners(written.begin() + std::ptrdiff_t(k) - 2,
                                  written.begin() + std::ptrdiff_t(k) + 1);
      if ((k - from) % 2 == 1) std::swap(corners[0], corners[1]);
      // Strips are joined by triangles without area.
      if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0])
        read_face(lines, corners, vertex_count, mesh);
    }
  }
}

}  // namespace

geometry::TriangleMesh parse_ply(std::string_view bytes, const std::string& path) {
  TextLines lines(bytes, path);
  const Header header = read_header(lines);
  check_format(lines, bytes, header);
  geometry::TriangleMesh mesh;
  Values values(lines, bytes, header);
  // Faces may stand before the vertices they refer to.
  std::size_t vertex_count = 0;
  for (const auto& element : header.elements) {
    if (element.name == "vertex") vertex_count = element.count;
  }
  for (const auto& element : header.elements) {
    // Every item of every element is read, wanted or not: a body has no other structure.
    if (element.properties.empty()) continue;
    for (std::size_t i = 0; i < element.count; ++i) {
      values.at(element, i);
      Vec3 point = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
      for (const auto& property : element.properties) {
        // Single numbers: those called x, y and z are the point.
        if (!property.list) {
          const double value = values.next(property.kind);
          for (int axis = 0; axis < 3; ++axis) {
            if (property.name == std::string(1, char('x' + axis))) point[axis] = value;
          }
          continue;
        }
        // Lists: those of a face that hold its corners.
        const double count = values.next(property.count_kind);
        const bool corners = property.name == "vertex_indices" || property.name == "vertex_index";
        const bool strips = element.name == "tristrips" && corners;
        const double most = strips ? kMostOfStrips : kMostCorners;
        if (!(count >= 0 && count <= most))
          lines.fail(
              shortest(count) + " list entries", "0 to " + shortest(most),
              "is the format line right (text, low or high byte first), and the file whole?");
        std::vector<double> list;
        for (int k = 0; k < int(count); ++k) list.push_back(values.next(property.kind));
        if (strips) read_strips(lines, list, vertex_count, mesh);
        if (element.name == "face" && corners) read_face(lines, list, vertex_count, mesh);
      }
      if (element.name == "vertex") {
        for (int axis = 0; axis < 3; ++axis) check_coordinate(lines, point[axis]);
        mesh.vertices.push_back(point);
      }
    }
  }
  return mesh;
}

}  // namespace loosefit::io
