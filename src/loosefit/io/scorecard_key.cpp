#include "loosefit/io/scorecard_key.h"

#include <filesystem>

#include "loosefit/io/existing_file.h"
#include "loosefit/io/scorecard_file.h"

namespace loosefit::io {

std::string scorecard_of(ConfigReader& table, const std::string& key, const std::string& about,
                         bool of_lines) {
  std::string card = table.peek_text(key, "");
  table.declare(key, about);
  if (std::filesystem::path(card).extension() == ".toml")
    card = existing_file(table, key, about, kTomlFile);
  else
    table.choice(key, "", of_lines ? line_scorecard_names() : scorecard_names(), about);
  if (!card.empty() && !table.recording()) load_scorecard(card, of_lines);
  return card;
}

}  // namespace loosefit::io
