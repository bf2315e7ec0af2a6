#pragma once
#include <map>
#include <set>
#include <string>
#include <utility>
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

/// Link to the definition of a word at the foot of the page (sections_definitions.cpp), HTML.
std::string defined(const std::string& words, const std::string& term);

/// An HTML table; all texts are escaped. The first column is a row head, others are numbers.
class Table {
 public:
  explicit Table(std::vector<std::string> head) : head_(std::move(head)) {}
  /// `data`: attribute and value that tell a script what the row is about ({"site", "left arm"}).
  void add(std::vector<std::string> row, std::pair<std::string, std::string> data = {});
  /// The head of a column links to the definition of `term`.
  void define(std::size_t column, const std::string& term) { terms_[column] = term; }
  /// The column holds this quantity of what its row is about, for scripts that compare outputs
  /// (tools/find_contradictions.py).
  void tell(std::size_t column, const std::string& quantity) { quantities_[column] = quantity; }
  /// The column holds sentences, which may be broken into lines.
  void wrap(std::size_t column) { sentences_.insert(column); }
  /// Readers may sort it, and take it home as `name`.csv where it has a name.
  void make_sortable(std::string name = {});
  bool empty() const { return rows_.empty(); }
  std::string html() const;

 private:
  struct Row {
    std::vector<std::string> cells;
    std::pair<std::string, std::string> data;
  };
  std::vector<std::string> head_;
  std::map<std::size_t, std::string> terms_, quantities_;
  std::set<std::size_t> sentences_;
  std::vector<Row> rows_;
  bool sortable_ = false;
  std::string name_;
};

}  // namespace loosefit::report
