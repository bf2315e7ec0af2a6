#pragma once
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "loosefit/base/error.h"
#include "loosefit/base/types.h"
#include "loosefit/io/config_node.h"

namespace loosefit::io {

/// Allowed values of a number, bounds included, and the word for them in messages.
struct NumberRange {
  double low = -std::numeric_limits<double>::max();
  double high = std::numeric_limits<double>::max();
  std::string what = "a number";  ///< "metres", "kg/m²", "a fraction"
};

/// Reads one table of a configuration file, key by key, and remembers which keys it was asked for;
/// `finish` then refuses all others. Every message names file, line and dotted key, what was found
/// and what was expected.
class ConfigReader {
 public:
  /// Keeps a reference to the table.
  ConfigReader(const ConfigNode& table, std::string file, std::string path = {});

  bool has(const std::string& key) { return node(key) != nullptr; }
  /// The raw value, for keys of more than one type; nullptr if absent.
  const ConfigNode* node(const std::string& key);
  double number(const std::string& key, double fallback, const NumberRange& range);
  std::optional<double> optional_number(const std::string& key, const NumberRange& range);
  long long integer(const std::string& key, long long fallback, long long low, long long high);
  bool boolean(const std::string& key, bool fallback);
  std::string text(const std::string& key, const std::string& fallback);
  /// A text that must be one of `known`.
  std::string choice(const std::string& key, const std::string& fallback,
                     const std::vector<std::string>& known);
  /// An array of texts from `known`, none twice.
  std::vector<std::string> choices(const std::string& key, const std::vector<std::string>& fallback,
                                   const std::vector<std::string>& known);
  /// [u, v]; every coordinate within `range`. Required.
  Vec2 point(const std::string& key, const NumberRange& range);
  /// [[u, v], [u, v], …]. Required, at least `at_least`, at most 1000 points.
  std::vector<Vec2> points(const std::string& key, const NumberRange& range, std::size_t at_least);
  /// [a, b, …] of 1 to 1000 numbers within `range`. Required.
  std::vector<double> numbers(const std::string& key, const NumberRange& range);
  /// Sub-table; an empty one when absent.
  ConfigReader table(const std::string& key);
  /// `[[key]]`; none when absent.
  std::vector<ConfigReader> tables(const std::string& key);

  /// \throws InvalidInput for the first key that is none of `known`, with a did-you-mean. To be
  /// asked before a key is required: who misspells it is told of the slip, not of the lack.
  void only(const std::vector<std::string>& known) const;
  /// \throws InvalidInput for the first key that was never asked for, with a did-you-mean.
  void finish() const;

  const std::string& file() const { return file_; }
  std::vector<std::string> keys() const;
  /// Error at `key`: found what stands there (or nothing).
  InvalidInput error(const std::string& key, const std::string& expected,
                     const std::string& hint = {}) const;
  InvalidInput error(const std::string& key, const std::string& found, const std::string& expected,
                     const std::string& hint) const;

 private:
  Vec2 point_of(const std::string& key, const ConfigNode& node, const NumberRange& range) const;

  const ConfigNode* table_;
  std::string file_, path_;
  std::set<std::string> asked_;
};

}  // namespace loosefit::io
