#include "loosefit/io/text_lines.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"
#include "loosefit/io/text_encoding.h"

namespace loosefit::io {
namespace {

constexpr double kLargest = 1e9;
constexpr std::string_view kBlank = " \t\r";

}  // namespace

bool TextLines::next() {
  if (at_ >= text_.size()) return false;
  const std::size_t end = std::min(text_.find_first_of("\r\n", at_), text_.size());
  line_ = text_.substr(at_, end - at_);
  at_ = std::min(end + (text_.substr(end, 2) == "\r\n" ? 2 : 1), text_.size());
  ++number_;
  return true;
}

std::vector<std::string_view> TextLines::words() const {
  std::vector<std::string_view> found;
  for (std::size_t from = line_.find_first_not_of(kBlank); from != std::string_view::npos;) {
    std::size_t to = line_.find_first_of(kBlank, from);
    if (to == std::string_view::npos) to = line_.size();
    found.push_back(line_.substr(from, to - from));
    from = line_.find_first_not_of(kBlank, to);
  }
  return found;
}

double TextLines::number_of(std::string_view word) const {
  double value = 0;
  if (!number_in(word, value) || !(std::abs(value) < kLargest))
    fail("\"" + printable(std::string(word)) + "\"", "a coordinate");
  return value;
}

long TextLines::integer_of(std::string_view word) const {
  long value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc{} || end != word.data() + word.size()) {
    fail("\"" + printable(std::string(word)) + "\"", "a whole number");
  }
  return value;
}

void TextLines::fail(const std::string& found, const std::string& expected,
                     const std::string& hint) const {
  throw InvalidInput({path_, number_, ""}, found, expected, hint);
}

void TextLines::fail_cut_off(const std::string& found, const std::string& expected) const {
  fail("the end of the file " + found, expected, "the file is cut off: copy or export it again");
}

}  // namespace loosefit::io
