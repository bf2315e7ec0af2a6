#include "loosefit/io/pieces/quantity.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <initializer_list>
#include <vector>

#include "loosefit/io/pieces/cloth_words.h"

namespace loosefit::io {
namespace {

constexpr int kMost = 1000;

/// A run of letters, a run of digits or a sign of a text, and where it stands there.
struct Token {
  enum class Kind { word, number, sign } kind = Kind::sign;
  std::string text;  ///< small letters
  std::size_t begin = 0, end = 0;
  int number = -1;  ///< of digits and of words for numbers; −1: none
};

bool is_one_of(const std::string& word, std::initializer_list<const char*> list) {
  return std::any_of(list.begin(), list.end(), [&](const char* k) { return word == k; });
}
bool begins_as(const std::string& word, std::initializer_list<const char*> list) {
  return std::any_of(list.begin(), list.end(), [&](const char* k) { return word.starts_with(k); });
}

int number_of(const std::string& word) {
  if (is_one_of(word, {"one", "ein", "eins", "une", "uno", "una", "um", "uma", "een"})) return 1;
  if (is_one_of(word, {"two", "zwei", "deux", "dos", "due", "dois", "duas", "twee"})) return 2;
  if (is_one_of(word, {"three", "drei", "trois", "tres", "tre", "drie"})) return 3;
  if (is_one_of(word, {"four", "vier", "quatre", "cuatro", "quattro", "quatro"})) return 4;
  if (is_one_of(word, {"five", "f\xc3\xbcnf", "cinq", "cinco", "cinque", "vijf"})) return 5;
  if (is_one_of(word, {"six", "sechs", "seis", "sei", "zes"})) return 6;
  if (is_one_of(word, {"seven", "sieben", "sept", "siete", "sette", "sete", "zeven"})) return 7;
  if (is_one_of(word, {"eight", "acht", "huit", "ocho", "otto", "oito"})) return 8;
  if (is_one_of(word, {"nine", "neun", "neuf", "nueve", "nove", "negen"})) return 9;
  if (is_one_of(word, {"ten", "zehn", "dix", "diez", "dieci", "dez", "tien"})) return 10;
  if (is_one_of(word, {"twelve", "zw\xc3\xb6lf", "douze", "doce", "dodici", "doze", "twaalf"}))
    return 12;
  return -1;
}

/// A small letter, of Latin 1 in UTF-8 too: U+00C0 to U+00DE stand 32 below theirs.
char small(const std::string& before, char c) {
  const auto u = static_cast<unsigned char>(c);
  const bool accented = !before.empty() && static_cast<unsigned char>(before.back()) == 0xc3 &&
                        u >= 0x80 && u <= 0x9e && u != 0x97;
  return static_cast<char>(accented ? u + 0x20 : u < 0x80 ? std::tolower(u) : u);
}

std::vector<Token> tokens_of(const std::string& text) {
  std::vector<Token> tokens;
  for (std::size_t i = 0; i < text.size();) {
    const unsigned char c = text[i];
    Token token;
    token.begin = i;
    // The sign × is no letter.
    const bool times =
        c == 0xc3 && i + 1 < text.size() && static_cast<unsigned char>(text[i + 1]) == 0x97;
    if (times) {
      token.text = "x", token.kind = Token::Kind::word, i += 2;
    } else if (std::isdigit(c)) {
      while (i < text.size() && std::isdigit(static_cast<unsigned char>(text[i])))
        token.text += text[i++];
      token.kind = Token::Kind::number;
      const auto [end, error] =
          std::from_chars(token.text.data(), token.text.data() + token.text.size(), token.number);
      if (error != std::errc() || token.number > kMost) token.number = -1;
    } else if (std::isalpha(c) || c >= 0x80) {
      while (i < text.size() && (std::isalpha(static_cast<unsigned char>(text[i])) ||
                                 static_cast<unsigned char>(text[i]) >= 0x80))
        token.text += small(token.text, text[i++]);
      token.kind = Token::Kind::word;
      token.number = number_of(token.text);
    } else {
      token.text = text[i++];
      token.end = i;
      if (!std::isspace(c)) tokens.push_back(std::move(token));
      continue;
    }
    token.end = i;
    tokens.push_back(std::move(token));
  }
  return tokens;
}

/// "Teil 2" is the second one, "Teile: 2" are two.
bool is_plural_of_piece(const std::string& w) {
  return is_one_of(w, {"st\xc3\xbc"
                       "ck",
                       "stueck",
                       "st\xc3\xbc"
                       "ckzahl",
                       "stueckzahl", "teile", "pezzi", "piezas",
                       "pi\xc3\xa8"
                       "ces",
                       "pe\xc3\xa7"
                       "as",
                       "stuks"});
}
bool is_cut_word(const std::string& w) {
  return begins_as(w, {"zuschneid", "zuschnitt", "schneide", "couper", "coupez", "quantit",
                       "tagliare", "knippen", "cantidad", "quantidad", "quantity"}) ||
         is_one_of(
             w, {"cut", "cuts", "qty", "qte", "qtd", "qta", "anzahl", "menge", "cortar", "corte",
                 "cant", "aantal", "pieces", "pcs", "stk", "amount", "anz", "copies", "coupe"}) ||
         is_plural_of_piece(w);
}
bool is_piece_word(const std::string& w) {
  return is_one_of(w, {"piece", "pieces", "pc", "pcs", "stk",
                       "st\xc3\xbc"
                       "ck",
                       "stueck", "teil", "teile", "pezzi", "piezas",
                       "pi\xc3\xa8"
                       "ces",
                       "pe\xc3\xa7"
                       "as",
                       "off", "required", "needed", "stuks"});
}
bool is_and(const std::string& w) {
  return is_one_of(w, {"+", "&", "and", "und", "et", "y", "e", "en", "plus"});
}
/// Folds and stitches are made several times as well.
bool is_times_word(const std::string& w) {
  return is_one_of(w, {"times", "mal", "fois", "veces", "volte", "vezes", "keer"});
}
/// 1: the left hand, 2: the right hand, 0: none.
int hand_of(const std::string& w) {
  if (is_one_of(w, {"l", "left", "links", "linke", "gauche", "izquierda", "sinistra"})) return 1;
  if (is_one_of(w, {"r", "right", "rechts", "rechte", "droite", "droit", "derecha", "destra"}))
    return 2;
  return 0;
}
bool is_pair_word(const std::string& w) {
  return is_one_of(
      w, {"pair", "pairs", "paar", "paare", "paire", "paires", "pares", "paio", "paia", "pr"});
}
bool is_mirror_word(const std::string& w) {
  return begins_as(w, {"mirror", "gegengleich", "gespiegelt", "spiegel", "opposite", "revers",
                       "symmetr", "sym\xc3\xa9tr", "symetr", "sim\xc3\xa9tr", "simetr", "simmetr",
                       "espej", "espelh", "specular", "miroir", "gespiegeld"});
}
bool is_same_word(const std::string& w) {
  return is_one_of(w, {"identical", "same", "identisch", "gleich", "identiques", "iguales",
                       "identici", "iguais", "unmirrored"});
}

/// A count at a token: which ones it takes.
struct Found {
  std::size_t first = 0, last = 0;  ///< tokens
  int number = 0;
  bool pairs = false;
  int other_hand = 0;  ///< said beside the number
};

class Finder {
 public:
  explicit Finder(const std::string& text) : text_(text), tokens_(tokens_of(text)) {}

  std::optional<PieceCount> find(std::string* rest) {
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      const std::optional<Found> found = at(i);
      if (!found) continue;
      // What is said of this count ends where the next one begins.
      std::size_t end = found->last + 1;
      while (end < tokens_.size() && !at(end) && tokens_[end].text != ";") ++end;
      if (is_of_other_cloth(found->last + 1, end)) {
        i = end - 1;
        continue;
      }
      return count_of(*found, end, rest);
    }
    return {};
  }

 private:
  bool is_word(std::size_t i) const {
    return i < tokens_.size() && tokens_[i].kind == Token::Kind::word;
  }
  bool is_number(std::size_t i) const { return i < tokens_.size() && tokens_[i].number >= 0; }
  bool is_digits(std::size_t i) const {
    return i < tokens_.size() && tokens_[i].kind == Token::Kind::number;
  }
  /// Inches of a number stand at it; a quotation may end there as well.
  bool is_quote_unit(std::size_t i) const {
    const std::string& sign = tokens_[i].text;
    const std::string before = text_.substr(0, tokens_[i].begin);
    return is_one_of(sign, {"\"", "'"}) && tokens_[i].begin == tokens_[i - 1].end &&
           (std::count(before.begin(), before.end(), sign[0]) % 2 == 0 ||
            (i >= 4 && is_digits(i - 4) && tokens_[i - 3].text == sign));
  }
  /// The number before it is a length, an angle or a share.
  bool is_unit(std::size_t i) const {
    if (i == 0 || i >= tokens_.size() || !is_digits(i - 1)) return false;
    const std::string& unit = tokens_[i].text;
    if (unit == "in") {  // "cut 2 in main fabric"
      for (std::size_t k = i + 1; k < tokens_.size() && k < i + 4; ++k)
        if (is_own_cloth(tokens_[k].text) || is_any_cloth(tokens_[k].text) ||
            is_other_cloth(tokens_[k].text))
          return false;
      return true;
    }
    return is_one_of(unit, {"cm", "mm", "m", "inch", "inches", "zoll", "ft", "yd", "deg", "%",
                            "degrees", "\xc2\xb0", "\xe2\x80\xb3", "\xe2\x80\xb2", "\xe2\x80\x9d",
                            "\xe2\x80\x99"}) ||
           is_quote_unit(i);
  }
  /// A number of a size: "2 cm", "2 x 3 cm".
  bool is_measure(std::size_t i) const {
    return is_unit(i + 1) || (is_any_x(i + 1) && is_digits(i + 2) && is_unit(i + 3));
  }
  bool is_any_x(std::size_t i) const { return is_word(i) && tokens_[i].text == "x"; }
  /// A cut word in the same clause before the number, or beside what follows it.
  bool speaks_of_cut(std::size_t i) const {
    for (std::size_t k = i; k-- > 0 && !is_one_of(tokens_[k].text, {",", ";", "."});)
      if (is_word(k) && is_cut_word(tokens_[k].text)) return true;
    return is_word(i + 2) && is_cut_word(tokens_[i + 2].text);
  }
  /// "1 left, 1 right", "1+1": one number for each hand.
  std::optional<Found> of_hands(std::size_t first, std::size_t k) const {
    std::size_t i = k + 1;
    const int one = is_word(i) ? hand_of(tokens_[i].text) : 0;
    i += one > 0;
    const bool plus = i < tokens_.size() && tokens_[i].text == "+";
    if (i < tokens_.size() && is_one_of(tokens_[i].text, {",", "+", "/", "&", "and", "und", "et"}))
      ++i;
    if (!is_number(i) || is_measure(i)) return {};
    const int other = is_word(i + 1) ? hand_of(tokens_[i + 1].text) : 0;
    if (one + other != 3 && !(plus && one + other == 0)) return {};
    Found found{first, i + (other > 0), tokens_[k].number};
    found.other_hand = tokens_[i].number;
    return found;
  }
  /// "1 + mirror", "1 and 1 reversed": that many of the other hand as well.
  std::optional<Found> with_mirrored(std::size_t first, std::size_t k) const {
    std::size_t i = k + 1;
    if (i >= tokens_.size() || !is_and(tokens_[i].text)) return {};
    ++i;
    Found found{first, i, tokens_[k].number};
    found.other_hand = found.number;
    if (is_number(i) && !is_measure(i)) found.other_hand = tokens_[i++].number;
    if (is_times(i)) ++i;
    if (!is_word(i) || !is_mirror_word(tokens_[i].text)) return {};
    found.last = i;
    return found;
  }
  /// "cut left and right": one of each.
  std::optional<Found> both_hands(std::size_t first, std::size_t k) const {
    const std::size_t other = k + 2;
    if (!is_word(k) || !is_word(other) || hand_of(tokens_[k].text) == 0) return {};
    if (!is_and(tokens_[k + 1].text) && tokens_[k + 1].text != ",") return {};
    if (hand_of(tokens_[k].text) + hand_of(tokens_[other].text) != 3) return {};
    return Found{first, other, 1, true};
  }
  /// A small x or the sign ×; "2X" is a size.
  bool is_times(std::size_t i) const {
    return is_word(i) && tokens_[i].text == "x" && text_[tokens_[i].begin] != 'X';
  }

  std::optional<Found> at(std::size_t i) const {
    if (is_word(i) && is_cut_word(tokens_[i].text)) {
      std::size_t k = i + 1;
      while (k < tokens_.size() &&
             (is_one_of(tokens_[k].text, {":", "=", ".", "(", "[", "-", "#"}) ||
              is_cut_word(tokens_[k].text) || is_one_of(tokens_[k].text, {"a", "of", "x", "je"})))
        ++k;
      if (is_number(k) && !is_fraction(k) && !is_measure(k)) {
        if (const std::optional<Found> hands = of_hands(i, k)) return hands;
        if (const std::optional<Found> both = with_mirrored(i, k)) return both;
        return with_unit(i, k, tokens_[k].number);
      }
      if (const std::optional<Found> both = both_hands(i, k)) return both;
      // "2.0" is the number 2.
      if (is_number(k) && is_digits(k + 2) && is_fraction(k + 2) && !is_unit(k + 3) &&
          tokens_[k + 2].text.find_first_not_of('0') == std::string::npos)
        return with_unit(i, k + 2, tokens_[k].number);
      if (is_word(k) && is_pair_word(tokens_[k].text)) return Found{i, k, 1, true};
    }
    // "X2" is no size.
    if ((is_times(i) ||
         (is_any_x(i) && is_digits(i + 1) && tokens_[i].end == tokens_[i + 1].begin)) &&
        is_digits(i + 1) && is_number(i + 1) && (i == 0 || !(is_digits(i - 1) || is_unit(i - 1))) &&
        !is_measure(i + 1) && !is_fraction(i + 1) &&
        !(is_word(i + 2) && tokens_[i + 2].begin == tokens_[i + 1].end))
      return with_unit(i, i + 1, tokens_[i + 1].number);
    if (is_number(i) && !is_fraction(i)) {
      if (const std::optional<Found> both = with_mirrored(i, i)) return both;
      const bool digits = is_digits(i);
      if (digits && is_times(i + 1) && !is_digits(i + 2)) return Found{i, i + 1, tokens_[i].number};
      if (is_word(i + 1) && is_pair_word(tokens_[i + 1].text))
        return Found{i, i + 1, tokens_[i].number, true};
      if (is_word(i + 1) && is_piece_word(tokens_[i + 1].text))
        return Found{i, i + 1, tokens_[i].number};
      if (is_word(i + 1) && is_times_word(tokens_[i + 1].text) && speaks_of_cut(i))
        return Found{i, i + 1, tokens_[i].number};
    }
    if (is_word(i) && is_pair_word(tokens_[i].text) && tokens_[i].text != "pr")
      return Found{i, i, 1, true};
    return {};
  }

  /// Digits that are a part of a number with a point or a comma.
  bool is_fraction(std::size_t i) const {
    const auto joined = [&](std::size_t a) {
      return is_digits(a) && is_digits(a + 2) &&
             (tokens_[a + 1].text == "." || tokens_[a + 1].text == ",") &&
             tokens_[a].end == tokens_[a + 1].begin && tokens_[a + 1].end == tokens_[a + 2].begin;
    };
    return joined(i) || (i >= 2 && joined(i - 2));
  }

  Found with_unit(std::size_t first, std::size_t number, int value) const {
    Found found{first, number, value};
    std::size_t k = number + 1;
    if (is_times(k) && !is_digits(k + 1)) found.last = k++;
    if (is_word(k) && is_pair_word(tokens_[k].text)) found.last = k, found.pairs = true;
    if (is_word(k) && (is_piece_word(tokens_[k].text) || is_times_word(tokens_[k].text)))
      found.last = k;
    return found;
  }

  bool is_of_other_cloth(std::size_t begin, std::size_t end) const {
    bool other = false, own = false;
    for (std::size_t k = begin; k < end; ++k) {
      other |= is_other_cloth(tokens_[k].text);
      own |= is_own_cloth(tokens_[k].text) || is_any_cloth(tokens_[k].text);
    }
    return other && !own;
  }

  PieceCount count_of(const Found& found, std::size_t end, std::string* rest) const {
    std::size_t last = found.last;
    bool mirrored = false, same = false;
    for (std::size_t k = found.last + 1; k < end; ++k) {
      const bool mirror = is_word(k) && is_mirror_word(tokens_[k].text);
      const bool no = mirror && k > 0 && is_one_of(tokens_[k - 1].text, {"not", "non", "nicht"});
      const bool alike = is_word(k) && is_same_word(tokens_[k].text);
      mirrored |= mirror && !no;
      same |= no || alike;
      if (mirror || alike) last = k;
    }
    PieceCount count;
    count.said =
        text_.substr(tokens_[found.first].begin, tokens_[last].end - tokens_[found.first].begin);
    const int n = found.number;
    if (found.other_hand > 0) {
      count.as_drawn = n, count.mirrored = found.other_hand;
    } else if (found.pairs) {
      count.as_drawn = count.mirrored = n;
    } else if (same) {
      count.as_drawn = n;
    } else if (n % 2 == 0) {
      count.as_drawn = count.mirrored = n / 2;
    } else if (mirrored && n == 1) {
      count.as_drawn = count.mirrored = 1;
      count.doubt = "one as drawn and one mirrored";
    } else {
      count.as_drawn = mirrored ? n / 2 + 1 : n;
      count.mirrored = mirrored ? n / 2 : 0;
    }
    if (rest) {
      *rest = text_.substr(0, tokens_[found.first].begin) + text_.substr(tokens_[last].end);
      const auto is_end = [](char c) {
        return std::string(" ,;:-_()[]/\t").find(c) != std::string::npos;
      };
      while (!rest->empty() && is_end(rest->back())) rest->pop_back();
      rest->erase(0, rest->find_first_not_of(" ,;:-_)]/\t"));
    }
    return count;
  }

  const std::string& text_;
  std::vector<Token> tokens_;
};

}  // namespace

std::optional<PieceCount> find_quantity(const std::string& text, std::string* rest) {
  const std::string head = text.substr(0, 500);
  return Finder(head).find(rest);
}

std::optional<PieceCount> read_quantity(const std::string& value) {
  const std::string text = value.substr(0, 500);
  const std::vector<Token> t = tokens_of(text);
  const auto digits = [&](std::size_t i) { return t[i].kind == Token::Kind::number; };
  const auto signed_by = [&](std::initializer_list<const char*> signs) {
    return t.size() == 3 && digits(0) && digits(2) && t[0].number >= 0 && t[2].number >= 0 &&
           is_one_of(t[1].text, signs);
  };
  PieceCount count;
  count.said = text;
  const auto of_number = [&](int n) {
    count.as_drawn = n % 2 == 0 ? n / 2 : n;
    count.mirrored = n % 2 == 0 ? n / 2 : 0;
    return count;
  };
  if (t.size() == 1 && t[0].number >= 0) return of_number(t[0].number);
  const bool no_fraction = t.size() == 3 && t[2].text.find_first_not_of('0') == std::string::npos;
  if (signed_by({".", ","}) && no_fraction && t[0].number > 0) {
    // A pair of 1 and 0 is the number 1; a pair of 2 and 0 is not the number 2.
    if (t[0].number % 2 == 0)
      count.doubt = fmt::format("the number {}: half of them as drawn, half mirrored", t[0].number);
    return of_number(t[0].number);
  }
  if (signed_by({",", ";", "+", "/"})) {
    count.as_drawn = t[0].number, count.mirrored = t[2].number;
    if (count.mirrored > 1 && count.mirrored != count.as_drawn)
      count.doubt = fmt::format("{} as drawn and {} mirrored", count.as_drawn, count.mirrored);
    return count;
  }
  if (std::optional<PieceCount> found = find_quantity(text)) {
    found->said = text;
    return found;
  }
  // "2 mirrored", "two".
  if (!t.empty() && t[0].number >= 0 &&
      (t.size() == 1 || t[1].kind == Token::Kind::word || t[1].text == "(")) {
    const std::string as_words = "cut " + text;
    if (std::optional<PieceCount> found = find_quantity(as_words)) {
      found->said = text;
      return found;
    }
  }
  return {};
}

bool counts_pieces(const std::string& key) {
  std::string word;
  bool number = false, pieces = false;
  for (const Token& token : tokens_of(key)) {
    if (token.kind != Token::Kind::word) continue;
    word += token.text;
    number |= is_one_of(token.text, {"no", "nr", "num", "number", "numero", "nb", "nombre", "n",
                                     "anzahl", "anz", "count", "n\xc3\xbamero"});
    pieces |= is_cut_word(token.text) || is_piece_word(token.text);
  }
  // "No. of pieces", "Nb de pièces", "Anzahl Teile".
  if (number && pieces) return true;
  return is_one_of(word, {"quantity",
                          "quantities",
                          "qty",
                          "qte",
                          "qtd",
                          "qta",
                          "cut",
                          "cutquantity",
                          "cutqty",
                          "cuts",
                          "anzahl",
                          "anz",
                          "menge",
                          "st\xc3\xbc"
                          "ckzahl",
                          "stueckzahl",
                          "st\xc3\xbc"
                          "ck",
                          "quantite",
                          "quantit\xc3\xa9",
                          "cantidad",
                          "quantita",
                          "quantit\xc3\xa0",
                          "quantidade",
                          "aantal",
                          "amount",
                          "pieces",
                          "pcs",
                          "count",
                          "piececount",
                          "numberofpieces",
                          "noofpieces",
                          "copies"});
}

bool speaks_of_count(const std::string& text) {
  bool cut = false, number = false, hands = false, mirror = false;
  for (const Token& token : tokens_of(text.substr(0, 500))) {
    cut |= token.kind == Token::Kind::word && is_cut_word(token.text);
    number |= token.kind == Token::Kind::number;
    hands |= hand_of(token.text) > 0 || token.text == "both";
    mirror |= token.kind == Token::Kind::word && is_mirror_word(token.text);
  }
  return !find_quantity(text) && ((cut && (number || hands)) || (mirror && number));
}

}  // namespace loosefit::io
