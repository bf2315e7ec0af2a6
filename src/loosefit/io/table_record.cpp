#include "loosefit/io/table_record.h"

#include <algorithm>

namespace loosefit::io {
namespace {

using Tables = std::vector<std::shared_ptr<TableRecord>>;

bool alike(const TableRecord& a, const TableRecord& b) {
  return a.keys.size() == b.keys.size() &&
         std::all_of(a.keys.begin(), a.keys.end(), [&](const KeyRecord& key) {
           return std::any_of(b.keys.begin(), b.keys.end(), [&](const KeyRecord& other) {
             return key.name == other.name && key.required == other.required &&
                    key.allowed == other.allowed;
           });
         });
}

template <class T>
void add_missing(std::vector<T>& all, const std::vector<T>& more) {
  for (const T& one : more)
    if (std::find(all.begin(), all.end(), one) == all.end()) all.push_back(one);
}

/// Alternatives of the tables below, put together.
void tidy(TableRecord& record) {
  for (KeyRecord& key : record.keys) {
    const Tables seen = std::move(key.tables);
    key.tables.clear();
    for (const auto& table : seen) add_alternative(key.tables, table);
  }
}

}  // namespace

KeyRecord& TableRecord::key(const std::string& name) {
  for (KeyRecord& key : keys)
    if (key.name == name) return key;
  KeyRecord made;
  made.name = name;
  keys.push_back(std::move(made));
  return keys.back();
}

void add_alternative(Tables& alternatives, const std::shared_ptr<TableRecord>& record) {
  if (!record->finished) return;
  tidy(*record);
  for (const auto& other : alternatives) {
    if (!alike(*other, *record)) continue;
    for (const KeyRecord& key : record->keys) {
      KeyRecord& same = other->key(key.name);
      add_missing(same.forms, key.forms);
      for (const auto& table : key.tables) add_alternative(same.tables, table);
      if (same.about.empty()) same.about = key.about;
      if (same.fallback.empty()) same.fallback = key.fallback;
    }
    add_missing(other->needs, record->needs);
    add_missing(other->clashes, record->clashes);
    return;
  }
  alternatives.push_back(record);
}

}  // namespace loosefit::io
