#include "loosefit/io/pieces/cloth_words.h"

#include <cctype>

namespace loosefit::io {

std::vector<std::string> words_in(const std::string& text) {
  std::vector<std::string> words(1);
  for (const char c : text) {
    const unsigned char u = c;
    if (std::isalpha(u) || u >= 0x80)
      words.back() += static_cast<char>(std::tolower(u));
    else if (!words.back().empty())
      words.emplace_back();
  }
  if (words.back().empty()) words.pop_back();
  return words;
}

bool is_other_cloth(const std::string& word) {
  for (const char* begins :
       {"lining", "interlin", "interfac", "fusible", "fusing", "futter", "einlage", "vlieseline",
        "doublure", "entoil", "thermocoll", "entretela", "forro", "fodera", "voering"})
    if (word.starts_with(begins)) return true;
  return false;
}

bool is_own_cloth(const std::string& word) {
  for (const char* is : {"self", "shell", "main", "outer", "body", "oberstoff"})
    if (word == is) return true;
  return false;
}

bool is_any_cloth(const std::string& word) {
  for (const char* is : {"fabric", "tissu", "tela", "tecido", "tessuto", "stof", "stoff"})
    if (word == is) return true;
  return false;
}

}  // namespace loosefit::io
