#include "loosefit/study/set_aside.h"

#include <algorithm>

#include "loosefit/io/plain_files.h"

namespace loosefit::study {

std::filesystem::path set_aside(const std::filesystem::path& file, const std::string& why,
                                const std::vector<std::string>& endings) {
  int number = 1;
  const auto aside = [&] { return file.string() + "." + why + "-" + std::to_string(number); };
  const auto is_taken = [&](const std::string& ending) { return io::is_there(aside() + ending); };
  while (is_taken("") || std::ranges::any_of(endings, is_taken)) ++number;
  for (const std::string& ending : endings)
    if (const std::string beside = file.string() + ending; io::is_there(beside))
      io::move_to_free_name(beside, aside() + ending);
  io::move_to_free_name(file, aside());
  return aside();
}

}  // namespace loosefit::study
