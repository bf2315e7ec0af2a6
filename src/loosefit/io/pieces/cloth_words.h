#pragma once
#include <string>
#include <vector>

namespace loosefit::io {

/// Runs of letters of a text, small ones where they are Latin.
std::vector<std::string> words_in(const std::string& text);

/// Linings, interlinings and fusibles in English, German, French, Spanish, Italian, Portuguese and
/// Dutch.
bool is_other_cloth(const std::string& word);

/// Words for the garment's own cloth: self, shell, main, …
bool is_own_cloth(const std::string& word);

/// Words of any cloth: a garment's own one beside a lining ("Tela, forro"), no other than the
/// lining where they stand with it ("Tela de forro").
bool is_any_cloth(const std::string& word);

}  // namespace loosefit::io
