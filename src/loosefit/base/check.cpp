#include "loosefit/base/check.h"

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "loosefit/base/error.h"

namespace loosefit {
namespace {

/// The path from the last folder "loosefit" on: the same wherever the source was compiled.
std::string_view short_path(std::string_view file) {
  const std::size_t at = file.rfind("loosefit/");
  return at == std::string_view::npos ? file : file.substr(at);
}

}  // namespace

void require(bool holds, const char* expected, std::source_location here) {
  if (holds) return;
  throw Error(fmt::format("internal error: {} does not hold ({}:{})", expected,
                          short_path(here.file_name()), here.line()),
              "this is a defect of Loosefit; please report it with the scenario");
}

void assertion_failed(const char* expression, const char* file, int line) {
  std::fprintf(stderr, "%s:%d: assertion failed: %s\n", file, line, expression);
  std::abort();
}

}  // namespace loosefit
