#pragma once
#include <set>
#include <string>

#include "loosefit/io/config_node.h"

// Scenarios of a study are made by changing the table of a base scenario, which is then read as any
// other: so a case is judged by the very rules of `loosefit run`.
namespace loosefit::study {

io::ConfigNode number_node(double value, int line = 0);
io::ConfigNode integer_node(long long value, int line = 0);
io::ConfigNode text_node(const std::string& text, int line = 0);

/// Puts `value` at a dotted key ("garment.fit.chest"; "site[0].angle_deg" in an array that is there
/// already), making tables on the way. \throws InvalidInput, key `dotted`, where something else
/// stands on the way or an array has no such item.
void set_value(io::ConfigNode& root, const std::string& dotted, const io::ConfigNode& value);

/// Members of `patch` over those of `base`: tables are merged, all else is replaced.
void merge_tables(io::ConfigNode& base, const io::ConfigNode& patch);

/// Says of a value and all below it in which file it stands, for errors and for the paths in it.
void stands_in(io::ConfigNode& node, const std::string& file);

/// The value at a dotted key of tables; nullptr if absent.
const io::ConfigNode* value_at(const io::ConfigNode& root, const std::string& dotted);

/// Dotted keys of all values of a table and of the tables in it; an array is one value.
std::set<std::string> keys_of_values(const io::ConfigNode& table);

/// The same text for the same value, wherever it stands: 1 is 1.0, and members have no order.
std::string value_text(const io::ConfigNode& value);

}  // namespace loosefit::study
