#pragma once
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "loosefit/base/error.h"
#include "loosefit/base/types.h"
#include "loosefit/io/config_node.h"
#include "loosefit/io/table_record.h"

namespace loosefit::io {

/// Allowed values of a number, bounds included, and the word for them in messages.
struct NumberRange {
  double low = -std::numeric_limits<double>::max();
  double high = std::numeric_limits<double>::max();
  std::string what = "a number";  ///< "metres", "kg/m²", "a fraction"
};

/// Unit of such a number: "m", "kg/m²"; empty for a pure one.
std::string unit_of(const NumberRange& range);

/// For a length out of its range that would lie in it as one in cm, or else in mm: "lengths are in
/// metres: 168 cm is 1.68". Empty for all else.
std::string unit_hint(double value, const NumberRange& range);

/// Reads one table of a configuration file, key by key, and remembers which keys it was asked for;
/// `finish` then refuses all others. Every message names file, line and dotted key, what was found
/// and what was expected. `about` says to people what a key is; it and all else that is said of a
/// key is noted in the record, if there is one, from which a schema is made: what is refused here
/// and what the schema refuses come from one declaration.
class ConfigReader {
 public:
  /// Keeps a reference to the table, and to `record`.
  ConfigReader(const ConfigNode& table, std::string file, std::string path = {},
               TableRecord* record = nullptr);

  /// Whether this reading is for the record: files that are named need not be there.
  bool recording() const { return record_ != nullptr; }
  bool has(const std::string& key) { return node(key) != nullptr; }
  /// The raw value, for keys of more than one type; nullptr if absent.
  const ConfigNode* node(const std::string& key);
  double number(const std::string& key, double fallback, const NumberRange& range,
                const std::string& about = {});
  /// `usual`: what holds where it is absent, for the record.
  std::optional<double> optional_number(const std::string& key, const NumberRange& range,
                                        const std::string& about = {},
                                        std::optional<double> usual = {});
  long long integer(const std::string& key, long long fallback, long long low, long long high,
                    const std::string& about = {});
  bool boolean(const std::string& key, bool fallback, const std::string& about = {});
  std::string text(const std::string& key, const std::string& fallback,
                   const std::string& about = {});
  /// The same without a record: of a text that decides how it is read.
  std::string peek_text(const std::string& key, const std::string& fallback);
  /// A text that names a file: one that matches the regular expression `pattern`, if that is given.
  std::string path(const std::string& key, const std::string& pattern, const std::string& about);
  /// A text that must be one of `known`.
  std::string choice(const std::string& key, const std::string& fallback,
                     const std::vector<std::string>& known, const std::string& about = {});
  /// An array of texts from `known`, none twice, at least so many.
  std::vector<std::string> choices(const std::string& key, const std::vector<std::string>& fallback,
                                   const std::vector<std::string>& known,
                                   const std::string& about = {}, std::size_t at_least = 0);
  /// An array of texts, none twice, at least so many, that match a regular expression: which is for
  /// the record, the caller judges them.
  std::vector<std::string> texts(const std::string& key, const std::string& pattern,
                                 const std::string& about, std::size_t at_least);
  /// A text that matches such an expression.
  std::string matching(const std::string& key, const std::string& pattern,
                       const std::string& about);
  /// [u, v]; every coordinate within `range`. Required.
  Vec2 point(const std::string& key, const NumberRange& range, const std::string& about = {});
  /// The same; [0, 0] where it is absent.
  Vec2 point_or_zero(const std::string& key, const NumberRange& range,
                     const std::string& about = {});
  /// [[u, v], [u, v], …]. Required, at least `at_least`, at most 1000 points.
  std::vector<Vec2> points(const std::string& key, const NumberRange& range, std::size_t at_least,
                           const std::string& about = {});
  /// [a, b, …] of 1 to 1000 numbers within `range`. Required. `count`: how many the caller takes,
  /// for the record; 0: any.
  std::vector<double> numbers(const std::string& key, const NumberRange& range,
                              const std::string& about = {}, std::size_t count = 0);
  /// Sub-table; an empty one when absent.
  ConfigReader table(const std::string& key, const std::string& about = {});
  /// Sub-table, if it is there.
  std::optional<ConfigReader> optional_table(const std::string& key, const std::string& about = {});
  /// `[[key]]`; none when absent.
  std::vector<ConfigReader> tables(const std::string& key, const std::string& about = {},
                                   std::size_t most = 200);

  /// \throws InvalidInput when the key is absent.
  void require(const std::string& key, const std::string& expected);
  /// A boolean that may only be true. \throws InvalidInput with `expected`.
  void always_true(const std::string& key, const std::string& about, const std::string& expected);
  /// Whether `key` is there without `other`, which it needs.
  bool lacks(const std::string& key, const std::string& other);
  /// Whether both are there, of which there may be one only.
  bool clash(const std::string& key, const std::string& other);

  // For the record alone.
  /// A key that is read further on in one way or another.
  void declare(const std::string& key, const std::string& about, const std::string& usual = {});
  /// That what is read beside this text holds for these values of it; where it is absent, too,
  /// unless it stands in this table.
  void only_for(const std::string& key, const std::vector<std::string>& values);

  /// \throws InvalidInput for the first key that is none of `known`, with a did-you-mean. To be
  /// asked before a key is required: who misspells it is told of the slip, not of the lack.
  void only(const std::vector<std::string>& known) const;
  /// \throws InvalidInput for the first key that was never asked for, with a did-you-mean.
  void finish() const;

  const std::string& file() const { return file_; }
  /// Of a value, which may have been laid over the table from another file.
  const std::string& file_of(const std::string& key) const;
  std::vector<std::string> keys() const;
  /// Error at `key`: found what stands there (or nothing).
  InvalidInput error(const std::string& key, const std::string& expected,
                     const std::string& hint = {}) const;
  InvalidInput error(const std::string& key, const std::string& found, const std::string& expected,
                     const std::string& hint) const;

 private:
  void note(const std::string& key, const ValueForm& form, const std::string& about,
            const std::string& fallback = {});
  Vec2 point_of(const std::string& key, const ConfigNode& node, const NumberRange& range) const;

  const ConfigNode* table_;
  std::string file_, path_;
  std::set<std::string> asked_;
  TableRecord* record_ = nullptr;
};

}  // namespace loosefit::io
