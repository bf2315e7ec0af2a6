#include "loosefit/io/dxf/dxf_pieces.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <utility>

#include "loosefit/io/dxf/dxf_keys.h"
#include "loosefit/io/pieces/cloth_words.h"
#include "loosefit/io/pieces/quantity.h"

namespace loosefit::io {
namespace {

constexpr const char* kParting = ",;+&/";  // of what a text says of several cloths
constexpr const char* kPartingAndDigits = ",;+&/0123456789";

std::string trimmed(const std::string& s) {
  const std::size_t a = s.find_first_not_of(" \t"), b = s.find_last_not_of(" \t");
  return a == std::string::npos ? std::string() : s.substr(a, b - a + 1);
}

struct KeyValue {
  std::string key, value;
};

bool is_text(const DxfEntity& e) { return e.kind == "TEXT" || e.kind == "MTEXT"; }

std::optional<KeyValue> key_value(const DxfEntity& e) {
  if (!is_text(e)) return {};
  const std::size_t colon = e.text.find(':');
  if (colon == std::string::npos) return {};
  return KeyValue{dxf_key(trimmed(e.text.substr(0, colon))), trimmed(e.text.substr(colon + 1))};
}

bool has_outline(const DxfBlock& block) {
  return std::any_of(block.entities.begin(), block.entities.end(), [](const DxfEntity& e) {
    return (e.layer == 1 || e.layer == 84) && e.points.size() > 1;
  });
}

/// The beginning, not cut within a letter of UTF-8.
std::string shortened(std::string s) {
  constexpr std::size_t kMost = 100;
  if (s.size() <= kMost) return s;
  std::size_t end = kMost;
  while (end > 0 && (static_cast<unsigned char>(s[end]) >> 6) == 2) --end;
  s.resize(end);
  return s;
}

void set_once(std::string& to, const std::string& value) {
  if (to.empty()) to = shortened(value);
}

/// Words of the parts of a text, which signs and words for "and" part.
std::vector<std::vector<std::string>> parts_in(const std::string& text, const char* signs) {
  std::vector<std::vector<std::string>> parts(1);
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find_first_of(signs, at), text.size());
    for (const std::string& word : words_in(text.substr(at, end - at)))
      if (word == "and" || word == "und" || word == "et" || word == "y" || word == "e")
        parts.emplace_back();
      else
        parts.back().push_back(word);
    parts.emplace_back();
    at = end + 1;
  }
  return parts;
}

bool says_nothing_of_cloth(const std::string& word) {
  for (const char* is :
       {"cut", "x", "of", "de", "di", "pc", "pcs", "piece", "pieces", "pair", "only"})
    if (word == is) return true;
  return false;
}

}  // namespace

bool is_known_text(const std::string& text) {
  const std::string key = dxf_key(trimmed(text.substr(0, text.find(':'))));
  if (counts_pieces(key)) return true;
  for (const char* known : {"piece name", "size", "category", "fabric", "material", "annotation",
                            "style name", "sample size", "units"})
    if (key == known) return true;
  return false;
}

std::string of_other_cloth(const DxfPiece& piece) {
  const auto has = [](const std::vector<std::string>& words, bool (*is)(const std::string&)) {
    return std::any_of(words.begin(), words.end(), is);
  };
  for (const auto& part : parts_in(piece.fabric, kParting))
    if (has(part, is_own_cloth) && !has(part, is_other_cloth)) return {};
  for (const auto& [key, text] :
       {std::pair{"Fabric", &piece.fabric}, std::pair{"Category", &piece.category},
        std::pair{"Annotation", &piece.annotation}}) {
    const bool annotation = text == &piece.annotation;
    bool other = false, own = false;
    // "Cut 2 self 2 lining" is an annotation in two parts, "Fabric 2 lining" a cloth.
    for (const auto& part : parts_in(*text, annotation ? kPartingAndDigits : kParting)) {
      const bool of_other = has(part, is_other_cloth);
      other |= of_other;
      own |= !of_other && (has(part, is_own_cloth) || has(part, is_any_cloth));
      // "Fusible tape at the neck" is an annotation of a piece of the garment's cloth.
      own |= annotation && std::any_of(part.begin(), part.end(), [](const std::string& word) {
               return !is_other_cloth(word) && !is_own_cloth(word) && !is_any_cloth(word) &&
                      !says_nothing_of_cloth(word);
             });
    }
    if (other && !own) return std::string(key) + " \"" + *text + '"';
  }
  return {};
}

DxfStyle find_pieces(const DxfDocument& document) {
  DxfStyle style;
  for (const DxfEntity& e : document.entities)
    if (const auto text = key_value(e)) {
      if (text->key == "style name") set_once(style.name, text->value);
      if (text->key == "sample size") set_once(style.sample_size, text->value);
      if (text->key == "units") set_once(style.units, text->value);
      if (text->key == "author" || text->key == "product")
        style.maker = shortened(style.maker + " " + text->value);
    }
  for (const DxfBlock& block : document.blocks) {
    if (block.name.starts_with("*") || !has_outline(block)) continue;
    DxfPiece piece;
    piece.block = &block;
    for (const DxfEntity& e : block.entities)
      if (is_text(e) && !key_value(e)) {
        piece.texts.push_back(e.text);
      } else if (const auto text = key_value(e)) {
        if (text->key == "piece name") set_once(piece.name, text->value);
        if (text->key == "size") set_once(piece.size, text->value);
        if (counts_pieces(text->key)) set_once(piece.quantity, text->value);
        if (text->key == "category") set_once(piece.category, text->value);
        if (text->key == "fabric" || text->key == "material") set_once(piece.fabric, text->value);
        if (text->key == "annotation") set_once(piece.annotation, text->value);
        if (!is_known_text(e.text) && find_quantity(e.text)) piece.texts.push_back(e.text);
      }
    if (piece.name.empty()) {
      piece.name = shortened(block.name);
      if (!piece.size.empty() && piece.name.ends_with("_" + piece.size))
        piece.name.resize(piece.name.size() - piece.size.size() - 1);
    }
    if (piece.name.empty()) piece.name = "piece";
    if (!piece.size.empty() &&
        std::find(style.sizes.begin(), style.sizes.end(), piece.size) == style.sizes.end())
      style.sizes.push_back(piece.size);
    style.pieces.push_back(std::move(piece));
  }
  return style;
}

}  // namespace loosefit::io
