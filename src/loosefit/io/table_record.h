#pragma once
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

// What a reader of configuration tables asks for, noted while it reads (io/config_reader.h).
namespace loosefit::io {

/// One form that a value may have.
struct ValueForm {
  std::string type = {};  ///< as in JSON Schema: "number", "string", "array", …
  std::optional<double> low = {}, high = {};  ///< of a number, bounds included
  std::string unit = {};                      ///< of a number; empty: none
  std::vector<std::string> known = {};        ///< of a text: no other; of a boolean: "true" alone
  std::string pattern = {};                   ///< of a text: a regular expression that it matches
  std::vector<ValueForm> items = {};          ///< of an array: the one form of all
  std::size_t least = 0, most = 0;            ///< of an array; most 0: no limit
  bool unique = false;                        ///< of an array
  bool operator==(const ValueForm&) const = default;
};

struct TableRecord;

/// A key of a table.
struct KeyRecord {
  std::string name, about;
  bool required = false;
  std::vector<ValueForm> forms;                      ///< any of these, or …
  std::vector<std::shared_ptr<TableRecord>> tables;  ///< … a table: any of these
  bool list = false;                                 ///< an array of such tables
  std::size_t most = 0;                              ///< of them
  std::vector<std::string> allowed;  ///< of the texts in `forms`, those of this alternative
  std::string fallback;              ///< value where it is absent, as JSON; empty: none
};

/// The keys that one way through a reader asks for, and how they depend on each other.
struct TableRecord {
  bool finished = false;  ///< read to its end, not only looked at
  std::vector<KeyRecord> keys;
  std::vector<std::pair<std::string, std::string>> needs;    ///< the first only beside the second
  std::vector<std::pair<std::string, std::string>> clashes;  ///< not both

  /// The record of a key, which is made when there is none.
  KeyRecord& key(const std::string& name);
};

/// Takes the record of another reading of the same table into the list of its alternatives. Two
/// that ask for the same keys, the same ones of them required and of the same allowed values, are
/// one; what each has seen below these keys is put together.
void add_alternative(std::vector<std::shared_ptr<TableRecord>>& alternatives,
                     const std::shared_ptr<TableRecord>& record);

}  // namespace loosefit::io
