#include "loosefit/io/pieces/left_out.h"

#include <fmt/format.h>

#include <algorithm>

#include "loosefit/base/text.h"

namespace loosefit::io {
namespace {

constexpr std::size_t kMostNames = 6;

}  // namespace

void LeftOut::tell(const std::string& line) {
  unused.push_back(line);
  warnings.push_back(line);
}

void LeftOut::count(const std::string& kind, const std::string& name) {
  auto found = std::find_if(counted_.begin(), counted_.end(),
                            [&](const Kind& one) { return one.kind == kind; });
  if (found == counted_.end()) found = counted_.insert(found, Kind{kind, 0, {}});
  ++found->number;
  if (!name.empty() && found->names.size() <= kMostNames)
    found->names.push_back(printable(name, 60));
}

void LeftOut::sum_up() {
  for (Kind& kind : counted_) {
    std::string line = fmt::format("{}: {}", kind.kind, kind.number);
    if (kind.names.size() > kMostNames) kind.names.back() = "...";
    if (!kind.names.empty()) line += " (" + join(kind.names) + ")";
    unused.push_back(line);
  }
  counted_.clear();
}

}  // namespace loosefit::io
