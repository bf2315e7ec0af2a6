#include "loosefit/io/output_name.h"

#include "loosefit/base/error.h"

namespace loosefit::io {

void check_output_name(const std::filesystem::path& name) {
  if (name.string().find_first_not_of(" \t\r\n") == std::string::npos)
    throw InvalidInput({"", 0, "output"}, name.empty() ? "an empty name" : "a name of blanks alone",
                       "the name of what to write");
}

}  // namespace loosefit::io
