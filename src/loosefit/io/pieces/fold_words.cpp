#include "loosefit/io/pieces/fold_words.h"

#include <algorithm>
#include <initializer_list>

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

/// "On the fold", "place to fold", "im Stoffbruch", "sur la pliure", "al doblez"; not "fold up at
/// the hem", "Saumbruch".
bool says_cut_there(const std::string& text) {
  constexpr std::size_t kBefore = 3;  // words between the two
  const auto is_one = [](const std::string& word, std::initializer_list<const char*> list) {
    return std::any_of(list.begin(), list.end(), [&](const char* is) { return word == is; });
  };
  const std::vector<std::string> words = words_in(text);
  for (std::size_t k = 0; k < words.size(); ++k) {
    if (is_one(words[k], {"onfold", "cutonfold", "bruch", "stoffbruch", "pliure", "doblez"}))
      return true;
    if (!pattern::words_of(words[k]).fold) continue;
    for (std::size_t i = k > kBefore ? k - kBefore : 0; i < k; ++i)
      if (is_one(words[i], {"on", "at", "to", "place", "am", "im", "auf", "an", "au", "sur", "en",
                            "al", "sulla", "op", "na", "no"}))
        return true;
  }
  return false;
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
