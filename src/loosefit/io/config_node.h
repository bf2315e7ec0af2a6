#pragma once
#include <string>
#include <utility>
#include <vector>

namespace loosefit::io {

/// One value of a configuration file with the line where it stands. Keeps the TOML library out of
/// every header: only toml_file.cpp knows it.
struct ConfigNode {
  enum class Kind { boolean, integer, number, text, other, array, table };
  Kind kind = Kind::table;
  int line = 0;
  std::string file;  ///< where it stands, if not in the file of the table that it has come to
  bool boolean = false;
  long long integer = 0;
  double number = 0;  ///< also set for integers
  std::string text;   ///< for `other` (dates, times): its name
  std::vector<ConfigNode> items;
  std::vector<std::pair<std::string, ConfigNode>> members;  ///< in order of their lines

  /// Member of a table by key; nullptr if absent.
  const ConfigNode* find(const std::string& key) const;
  /// What it is, for error messages: `17`, `"abc"`, `a table`, `an array of 3`.
  std::string describe() const;
};

/// A TOML basic string with its quotes, escaped.
std::string toml_quoted(const std::string& text);

}  // namespace loosefit::io
