#include "loosefit/base/control_characters.h"

#include <fmt/format.h>

#include <algorithm>

namespace loosefit {

std::size_t sequence_length(const std::string& text, std::size_t at) {
  const auto byte = [&](std::size_t i) -> unsigned char {
    return at + i < text.size() ? static_cast<unsigned char>(text[at + i]) : 0;
  };
  const unsigned char first = byte(0);
  if (first < 0x80) return 1;
  const std::size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  if (first < 0xc2 || first > 0xf4) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(i) & 0xc0) != 0x80) return 0;
  const bool overlong = (first == 0xe0 && byte(1) < 0xa0) || (first == 0xf0 && byte(1) < 0x90);
  const bool surrogate = first == 0xed && byte(1) > 0x9f, beyond = first == 0xf4 && byte(1) > 0x8f;
  return overlong || surrogate || beyond ? 0 : length;
}

char32_t code_point(const std::string& sequence) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(sequence[i]); };
  if (sequence.size() == 1) return byte(0);
  char32_t code = byte(0) & (0xffu >> (sequence.size() + 1));
  for (std::size_t i = 1; i < sequence.size(); ++i) code = code << 6 | (byte(i) & 0x3fu);
  return code;
}

namespace {

/// Whether a sequence moves the cursor, or turns or hides text: C0, DEL and C1, zero-width and
/// bidirectional marks, line separators, byte order marks.
bool is_control(const std::string& s) {
  const unsigned char first = static_cast<unsigned char>(s[0]);
  if (s.size() == 1) return first < 0x20 || first == 0x7f;
  if (s.size() == 2)
    return (first == 0xc2 && static_cast<unsigned char>(s[1]) < 0xa0) || s == "\u061c";
  if (s.size() == 4) return s >= "\U000e0000" && s <= "\U000e007f";
  return (s >= "\u200b" && s <= "\u200f") || (s >= "\u2028" && s <= "\u202e") ||
         (s >= "\u2060" && s <= "\u206f") || (s >= "\ufff9" && s <= "\ufffb") || s == "\ufeff" ||
         s == "\u180e";
}

}  // namespace

std::string replace_controls(const std::string& text,
                             const std::function<std::string(const std::string&)>& replaced) {
  std::string shown;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = sequence_length(text, at);
    const std::string sequence = text.substr(at, std::max<std::size_t>(length, 1));
    shown += length == 0 || is_control(sequence) ? replaced(sequence) : sequence;
    at += sequence.size();
  }
  return shown;
}

std::string json_without_controls(const std::string& document) {
  return replace_controls(document, [](const std::string& s) -> std::string {
    if (s.size() == 1) return s == "\x7f" ? "\\u007f" : s;  // JSON itself escapes those below 0x20
    const auto code = static_cast<unsigned>(code_point(s));
    if (code < 0x10000) return fmt::format("\\u{:04x}", code);
    return fmt::format("\\u{:04x}\\u{:04x}", 0xd800 + ((code - 0x10000) >> 10),
                       0xdc00 + ((code - 0x10000) & 0x3ff));
  });
}

}  // namespace loosefit
