#include "loosefit/io/text_encoding.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace loosefit::io {
namespace {

constexpr std::string_view kUtf8Mark = "\xef\xbb\xbf", kLittleMark = "\xff\xfe",
                           kBigMark = "\xfe\xff";
constexpr std::size_t kBeginning = 400;  // bytes that tell UTF-16 without a mark

void append_utf8(std::string& out, char32_t c) {
  const auto put = [&](char32_t byte) { out += static_cast<char>(byte); };
  if (c < 0x80) {
    put(c);
  } else if (c < 0x800) {
    put(0xc0 | (c >> 6)), put(0x80 | (c & 0x3f));
  } else if (c < 0x10000) {
    put(0xe0 | (c >> 12)), put(0x80 | ((c >> 6) & 0x3f)), put(0x80 | (c & 0x3f));
  } else {
    put(0xf0 | (c >> 18)), put(0x80 | ((c >> 12) & 0x3f));
    put(0x80 | ((c >> 6) & 0x3f)), put(0x80 | (c & 0x3f));
  }
}

std::string from_utf16(std::string_view bytes, bool little) {
  const auto unit = [&](std::size_t i) -> char32_t {
    const auto first = static_cast<unsigned char>(bytes[i]);
    const auto second = static_cast<unsigned char>(bytes[i + 1]);
    return static_cast<char32_t>(little ? first | second << 8 : first << 8 | second);
  };
  std::string text;
  for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
    char32_t c = unit(i);
    const bool pair = c >= 0xd800 && c < 0xdc00 && i + 3 < bytes.size() && unit(i + 2) >= 0xdc00 &&
                      unit(i + 2) < 0xe000;
    if (pair) {
      c = 0x10000 + ((c - 0xd800) << 10) + (unit(i + 2) - 0xdc00);
      i += 2;
    } else if (c >= 0xd800 && c < 0xe000) {
      c = 0xfffd;
    }
    append_utf8(text, c);
  }
  return text;
}

/// Whether the bytes at odd places (or at even ones) of the beginning are zeros, the others not.
bool zeros_at(std::string_view bytes, std::size_t place) {
  const std::size_t size = std::min(bytes.size(), kBeginning) / 2 * 2;
  if (size < 8) return false;
  for (std::size_t i = 0; i < size; ++i)
    if ((bytes[i] == '\0') != (i % 2 == place)) return false;
  return true;
}

}  // namespace

std::string plain_text(std::string bytes) {
  const std::string_view all = bytes;
  if (all.starts_with(kUtf8Mark))
    bytes.erase(0, kUtf8Mark.size());
  else if (all.starts_with(kLittleMark) || all.starts_with(kBigMark))
    bytes = from_utf16(all.substr(2), all.starts_with(kLittleMark));
  else if (zeros_at(all, 1) || zeros_at(all, 0))
    bytes = from_utf16(all, zeros_at(all, 1));
  if (bytes.find('\n') == std::string::npos) std::replace(bytes.begin(), bytes.end(), '\r', '\n');
  return bytes;
}

bool number_in(std::string_view text, double& value) {
  const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  while (!text.empty() && blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && blank(text.back())) text.remove_suffix(1);
  std::string word(text);
  if (word.starts_with('+') && !word.starts_with("+-")) word.erase(0, 1);
  if (std::count(word.begin(), word.end(), ',') == 1 && word.find('.') == std::string::npos)
    word[word.find(',')] = '.';
  const char* const end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  return error == std::errc{} && stop == end && std::isfinite(value);
}

}  // namespace loosefit::io
