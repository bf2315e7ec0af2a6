#include "loosefit/io/dxf/dxf_groups.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"
#include "loosefit/io/text_encoding.h"

namespace loosefit::io {
namespace {

constexpr double kLargestNumber = 1e7;

std::string_view trimmed(std::string_view s) {
  const auto space = [](char c) { return c == ' ' || c == '\t'; };
  while (!s.empty() && space(s.front())) s.remove_prefix(1);
  while (!s.empty() && space(s.back())) s.remove_suffix(1);
  return s;
}

std::string quoted(std::string_view value) {
  return '"' + printable(std::string(value.substr(0, 60))) + '"';
}

}  // namespace

const DxfGroup* DxfRecord::find(int code) const {
  for (const DxfGroup& group : groups)
    if (group.code == code) return &group;
  return nullptr;
}

std::string DxfRecord::text(int code) const {
  const DxfGroup* group = find(code);
  return group ? std::string(group->value) : std::string();
}

DxfRecords::DxfRecords(std::string_view text, std::string file)
    : text_(text), file_(std::move(file)) {
  if (text_.starts_with("\xef\xbb\xbf")) at_ = 3;
}

void DxfRecords::fail(int line, const std::string& key, const std::string& found,
                      const std::string& expected, const std::string& hint) const {
  throw InvalidInput({file_, line, key}, found, expected, hint);
}

bool DxfRecords::next_line(std::string_view& line) {
  if (at_ >= text_.size()) return false;
  const std::size_t end = std::min(text_.find_first_of("\r\n", at_), text_.size());
  line = text_.substr(at_, end - at_);
  at_ = end;
  if (at_ < text_.size()) at_ += text_[at_] == '\r' && text_.substr(at_, 2) == "\r\n" ? 2 : 1;
  ++line_;
  if (line.find('\0') != std::string_view::npos)
    fail(line_, "", "a byte 0", "text", "only DXF files in text form are read, no binary ones");
  return true;
}

bool DxfRecords::next_group(DxfGroup& group) {
  std::string_view line;
  do {
    if (!next_line(line)) return false;
    // Editors leave an empty line at the end of a file.
  } while (trimmed(line).empty() && text_.find_first_not_of(" \t\r\n", at_) == text_.npos);
  const std::string_view code = trimmed(line);
  const auto [end, error] = std::from_chars(code.data(), code.data() + code.size(), group.code);
  if (code.empty() || error != std::errc() || end != code.data() + code.size() || group.code < -5 ||
      group.code > 1071)
    fail(line_, "", quoted(code), "a group code, a whole number from -5 to 1071",
         "a DXF file is pairs of lines, a code and a value; a line is missing or too many");
  if (!next_line(group.value))
    fail(line_, "", "the end of the file", "the value of the group code " + std::string(code),
         "the file is cut off");
  group.value = trimmed(group.value);
  group.line = line_;
  return true;
}

bool DxfRecords::next(DxfRecord& record) {
  record = {};
  DxfGroup group;
  // Comments (code 999) may stand before the first record.
  while (!has_ahead_) {
    if (!next_group(group)) return false;
    if (group.code == 0)
      ahead_ = group, has_ahead_ = true;
    else if (group.code != 999)
      fail(group.line - 1, "", "the group code " + std::to_string(group.code),
           "0, which begins a section");
  }
  record.kind = ahead_.value;
  record.line = ahead_.line;
  has_ahead_ = false;
  while (next_group(group)) {
    if (group.code == 0) {
      ahead_ = group;
      has_ahead_ = true;
      break;
    }
    record.groups.push_back(group);
  }
  return true;
}

double DxfRecords::number(const DxfGroup& group) const {
  double value = 0;
  if (!number_in(group.value, value) || std::abs(value) > kLargestNumber)
    fail(group.line, "", quoted(group.value), "a number of at most 1e7");
  return value;
}

int DxfRecords::integer(const DxfGroup& group) const {
  const double value = number(group);
  if (value != std::floor(value)) fail(group.line, "", quoted(group.value), "a whole number");
  return static_cast<int>(value);
}

}  // namespace loosefit::io
