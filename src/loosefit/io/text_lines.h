#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace loosefit::io {

/// Splits the text of a file into lines and words and counts the lines for error messages. Lines
/// end in LF, CR LF or CR. Keeps a reference to the text.
class TextLines {
 public:
  TextLines(std::string_view text, std::string path) : text_(text), path_(std::move(path)) {}
  /// Moves to the next line; false at the end.
  bool next();
  std::vector<std::string_view> words() const;
  std::size_t offset() const { return at_; }  ///< of the byte behind the current line
  int number() const { return number_; }
  /// A decimal comma is a point. \throws InvalidInput when the word is no finite number below 1e9
  /// in size.
  double number_of(std::string_view word) const;
  /// \throws InvalidInput when the word is no whole number.
  long integer_of(std::string_view word) const;
  /// \throws InvalidInput, always, with file and line.
  [[noreturn]] void fail(const std::string& found, const std::string& expected,
                         const std::string& hint = {}) const;
  /// \throws InvalidInput, always: the file ends too early. \param found  what was read before
  [[noreturn]] void fail_cut_off(const std::string& found, const std::string& expected) const;
  bool at_end() const { return at_ >= text_.size(); }  ///< the current line is the last one

 private:
  std::string_view text_;
  std::string path_;
  std::string_view line_;
  std::size_t at_ = 0;
  int number_ = 0;
};

}  // namespace loosefit::io
