#pragma once
#include <memory>
#include <string>
#include <vector>

#include "loosefit/io/table_record.h"

namespace loosefit::io {

/// JSON Schema (draft 2020-12) of a table with these alternatives. Units stand in the annotation
/// `unit`. \throws std::logic_error for a key of which no reading has told a form.
std::string json_schema(const std::vector<std::shared_ptr<TableRecord>>& alternatives,
                        const std::string& title, const std::string& about);

}  // namespace loosefit::io
