#pragma once
#include <CLI/App.hpp>

namespace loosefit {

/// Every option and argument of the commands that takes a text refuses an empty one and one of
/// blanks alone: most are names of files and folders, and none would mean what it says.
void refuse_blank_values(CLI::App& app);

/// "--output=" of these words, where nothing stands behind the sign: the parser would take the next
/// word for it. Empty: there is none.
std::string value_left_out(int count, const char* const* words);

}  // namespace loosefit
