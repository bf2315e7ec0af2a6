#include "loosefit/io/svg/svg_labels.h"

#include <fmt/format.h>

#include <cctype>
#include <charconv>
#include <sstream>

#include "loosefit/base/text.h"

namespace loosefit::io {
namespace {

bool given_by_program(const std::string& id) {
  std::size_t letters = 0;
  while (letters < id.size() && std::isalpha(static_cast<unsigned char>(id[letters]))) ++letters;
  const std::string word = id.substr(0, letters);
  const bool counted =
      id.find_first_not_of("0123456789-_.", letters) == std::string::npos && letters < id.size();
  for (const char* known : {"path", "rect", "polygon", "polyline", "ellipse", "circle", "line", "g",
                            "use", "layer", "svg", "shape", "group", "image", "fs"})
    if (word == known && (counted || id == word)) return true;
  return false;
}

/// Illustrator writes what may not stand in an id by its code: "front_x5F_M" for "front_M".
std::string without_codes(const std::string& id) {
  std::string name;
  for (std::size_t i = 0; i < id.size(); ++i) {
    const std::size_t end = id.compare(i, 2, "_x") == 0 ? id.find('_', i + 2) : std::string::npos;
    int code = 0;
    if (end == i + 4) {
      const auto [rest, error] = std::from_chars(id.data() + i + 2, id.data() + end, code, 16);
      if (error != std::errc() || rest != id.data() + end || code < 0x20 || code > 0x7e) code = 0;
    }
    if (code == 0) {
      name += id[i];
    } else {
      name += static_cast<char>(code);
      i = end;
    }
  }
  return name;
}

}  // namespace

std::string own_name(const std::string& label, const std::string& id) {
  if (!label.empty()) return label;
  return given_by_program(id) ? std::string() : without_codes(id);
}

std::string all_labels(const SvgDocument& document, const SvgShape& shape) {
  std::string all = own_name(shape.label, shape.id);
  for (const int g : shape.groups)
    all += " " + own_name(document.groups[g].label, document.groups[g].id);
  return all;
}

std::string in_words(const std::string& text) {
  std::string words = " ";
  for (const char c : text) {
    const unsigned char u = c;
    if (std::isalnum(u) || u >= 0x80)
      words += static_cast<char>(std::tolower(u));
    else if (words.back() != ' ')
      words += ' ';
  }
  return words.back() == ' ' ? words : words + ' ';
}

bool has_words(const std::string& text, const std::string& wanted) {
  return in_words(text).find(in_words(wanted)) != std::string::npos;
}

bool has_words_of_other(const std::string& text, const std::string& other, const std::string& own) {
  std::istringstream words(in_words(other));
  for (std::string word; words >> word;)
    if (!has_words(own, word) && has_words(text, word)) return true;
  return false;
}

std::string described(const SvgDocument& document, const SvgShape& shape) {
  std::string name = own_name(shape.label, shape.id);
  if (!shape.groups.empty()) {
    const SvgGroup& group = document.groups[shape.groups.back()];
    const std::string around = own_name(group.label, group.id);
    if (!around.empty()) name += (name.empty() ? "in " : " in ") + around;
  }
  return name.empty() ? fmt::format("the one at line {}", shape.line) : '"' + printable(name) + '"';
}

std::string trimmed_words(const std::string& text) {
  std::istringstream words(text);
  std::string all;
  for (std::string word; words >> word;) all += (all.empty() ? "" : " ") + word;
  return all;
}

bool is_called_hole(const SvgDocument& document, const SvgShape& shape) {
  return words_of_shape(shape).hole ||
         (own_name(shape.label, shape.id).empty() && words_of_group(document, shape).hole);
}

std::string called_line(const SvgShape& shape) {
  const std::string name = own_name(shape.label, shape.id);
  return (name.empty() ? std::string() : '"' + printable(name, 60) + "\" ") +
         fmt::format("at line {}", shape.line);
}

pattern::PieceWords words_of_shape(const SvgShape& shape) {
  return pattern::words_of(own_name(shape.label, shape.id) + " " + shape.classes);
}

int innermost_group(const SvgShape& shape) {
  return shape.groups.empty() ? -1 : shape.groups.back();
}

pattern::PieceWords words_of_group(const SvgDocument& document, const SvgShape& shape) {
  const int g = innermost_group(shape);
  if (g < 0) return {};
  return pattern::words_of(own_name(document.groups[g].label, document.groups[g].id));
}

}  // namespace loosefit::io
