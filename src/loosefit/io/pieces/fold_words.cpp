#include "loosefit/io/pieces/fold_words.h"

#include <algorithm>

#include "loosefit/base/text.h"
#include "loosefit/io/pieces/cloth_words.h"
#include "loosefit/io/pieces/quantity.h"
#include "loosefit/pattern/piece_names.h"

namespace loosefit::io {
namespace {

/// The text without its count.
std::string beside_count(const std::string& text) {
  std::string rest;
  return find_quantity(text, &rest) ? rest : text;
}

/// "On fold", "place to fold", "im Stoffbruch", "sur la pliure", "al doblez".
bool says_cut_there(const std::string& text) {
  const std::vector<std::string> words = words_in(text);
  return std::any_of(words.begin(), words.end(), [](const std::string& word) {
    for (const char* is : {"on", "at", "to", "place", "cut", "am", "im", "auf", "an", "au", "sur",
                           "en", "al", "sulla", "op", "na", "no"})
      if (word == is) return true;
    for (const char* holds : {"bruch", "onfold", "pliure", "doblez", "mirror"})
      if (word.find(holds) != std::string::npos) return true;
    return false;
  });
}

}  // namespace

bool speaks_of_fold(const std::string& text) { return pattern::words_of(beside_count(text)).fold; }

void note_missing_fold(DrawnPiece& piece, const std::string& what, const std::string& text,
                       const std::string& mark) {
  if (!speaks_of_fold(text)) return;
  piece.half_without_fold = piece.half_without_fold || says_cut_there(text);
  piece.notes.push_back(what + (what == "its name" ? "" : " \"" + printable(text) + '"') +
                        " speaks of a fold, but " + mark + " says where: not unfolded");
}

}  // namespace loosefit::io
