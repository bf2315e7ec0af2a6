#include "set_aside_note.h"

#include <fmt/format.h>

#include <filesystem>

#include "loosefit/base/text.h"
#include "standard_error.h"

namespace loosefit {

void note_what_was_set_aside(const std::string& folder, const std::string& aside) {
  if (aside.empty()) return;
  to_standard_error(fmt::format("note: files that stood in the way are in {}\n",
                                terminal_line((std::filesystem::path(folder) / aside).string())));
}

}  // namespace loosefit
