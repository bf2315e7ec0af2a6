#include "set_aside_note.h"

#include <fmt/format.h>

#include <filesystem>

#include "loosefit/base/text.h"

namespace loosefit {

void note_what_was_set_aside(const std::string& folder, const std::string& aside) {
  if (aside.empty()) return;
  fmt::print(stderr, "note: files that stood in the way are in {}\n",
             terminal_line((std::filesystem::path(folder) / aside).string()));
}

}  // namespace loosefit
