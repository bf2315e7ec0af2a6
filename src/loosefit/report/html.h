#pragma once
#include <string>
#include <vector>

namespace loosefit::report {

/// Text safe inside elements and quoted attributes; control characters and what is not UTF-8 are
/// replaced by U+FFFD.
std::string escaped(const std::string& text);

/// RFC 4648 base64 with padding.
std::string base64(const std::string& bytes);

/// Number with `digits` significant digits, typographic minus; "–" for NaN and infinities.
std::string number(double value, int digits = 3);
/// Number with `decimals` digits after the point; never "−0".
std::string fixed(double value, int decimals);
/// Three significant digits or as many as asked for, with an explicit plus sign.
std::string signed_number(double value, int digits = 3);

/// `<tag class="…">content</tag>`; content is HTML already.
std::string element(const std::string& tag, const std::string& content,
                    const std::string& css_class = {});

/// An HTML table; all texts are escaped. The first column is a row head, others are numbers.
class Table {
 public:
  explicit Table(std::vector<std::string> head) : head_(std::move(head)) {}
  void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }
  bool empty() const { return rows_.empty(); }
  std::string html() const;

 private:
  std::vector<std::string> head_;
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace loosefit::report
