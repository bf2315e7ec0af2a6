#include "loosefit/kinds/find_size.h"

#include <algorithm>
#include <cctype>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"

namespace loosefit::kinds {
namespace {

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

}  // namespace

const KindSize& find_size(const std::vector<KindSize>& sizes, const std::string& name) {
  const auto size = std::find_if(sizes.begin(), sizes.end(),
                                 [&](const KindSize& s) { return lower(s.name) == lower(name); });
  if (size == sizes.end())
    throw InvalidInput({{}, 0, "size"}, '"' + printable(name) + '"', "a garment size",
                       did_you_mean(name, size_names(sizes)));
  return *size;
}

std::vector<std::string> size_names(const std::vector<KindSize>& sizes) {
  std::vector<std::string> names;
  for (const KindSize& size : sizes) names.push_back(size.name);
  return names;
}

}  // namespace loosefit::kinds
