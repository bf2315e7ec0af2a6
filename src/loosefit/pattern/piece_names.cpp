#include "loosefit/pattern/piece_names.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <utility>
#include <vector>

#include "loosefit/pattern/pattern.h"

namespace loosefit::pattern {
namespace {

/// Small letters, umlauts and accents as their plain letters.
std::vector<std::string> split(const std::string& name) {
  std::vector<std::string> words(1);
  bool small = false;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const unsigned char c = name[i];
    if (c == 0xc3 && i + 1 < name.size()) {  // Latin 1 in UTF-8
      const unsigned char d = static_cast<unsigned char>(name[++i]) | 0x20;
      words.back() += d == 0xa4                ? "ae"
                      : d == 0xb6              ? "oe"
                      : d == 0xbc              ? "ue"
                      : d == 0xbf              ? "ss"
                      : d >= 0xa0 && d <= 0xa6 ? "a"
                      : d >= 0xa8 && d <= 0xab ? "e"
                      : d >= 0xac && d <= 0xaf ? "i"
                      : d == 0xb1              ? "n"
                      : d >= 0xb2 && d <= 0xb5 ? "o"
                                               : "u";
      small = true;
    } else if (std::isalpha(c)) {
      if (std::isupper(c) && small && !words.back().empty()) words.emplace_back();
      words.back() += static_cast<char>(std::tolower(c));
      small = std::islower(c) != 0;
    } else if (!words.back().empty()) {
      words.emplace_back();
      small = false;
    }
  }
  return words;
}

struct Known {
  bool PieceWords::*what;
  std::vector<const char*> begins;           ///< the word begins so
  std::vector<const char*> is;               ///< the word is this
  std::vector<const char*> holds;            ///< the word has this in it
  std::vector<const char*> not_begins = {};  ///< but a word that begins so says something else
};

const std::vector<Known>& known() {
  using W = PieceWords;
  static const std::vector<Known> list = {
      {&W::front,
       {"front", "vorder", "vorne", "devant", "delant", "davant", "voor", "frente"},
       {"fr", "vt", "cf", "frt", "fnt", "ftorso"},
       {"front"}},
      {&W::back,
       {"back", "rueck", "ruck", "hint", "derriere", "tras", "posterior", "dos", "espald", "dietro",
        "achter", "costas"},
       {"bk", "ht", "cb", "bck", "btorso"},
       {"back"}},
      {&W::left, {"left", "link", "gauche", "izq", "sinistr"}, {"l", "lt", "lh"}, {}},
      {&W::right, {"right", "recht", "droit", "derech", "destr"}, {"r", "rh"}, {}},
      {&W::sleeve,
       {"sleeve", "aermel", "armel", "manche", "manga", "manic", "mouw"},
       {"sl", "slv"},
       {"sleeve", "aermel"}},
      {&W::armhole,
       {"armhole", "armscye", "armloch", "emmanchure", "sisa", "armsgat"},
       {},
       {"armhole", "armloch"}},
      {&W::leg,
       {"leg", "hose", "bein", "jambe", "pantal", "trouser", "pant", "broek", "pierna", "legging",
        "jean"},
       {},
       {"hose", "pants", "trouser"}},
      {&W::skirt, {"skirt", "rock", "jupe", "falda", "gonna", "saia"}, {}, {"skirt", "rock"}},
      {&W::top,
       {"bodice", "bandeau", "tube", "poncho", "cape", "umhang", "cloak", "shirt", "blus", "tunic",
        "oberteil", "top", "corsage", "mieder", "corpino"},
       {"tee"},
       {"shirt", "bluse"}},
      {&W::yoke, {"yoke", "passe", "sattel", "empiecement", "canesu"}, {"yk"}, {"yoke"}},
      {&W::pocket,
       {"pocket", "tasche", "poche", "bolsillo", "facing", "lining", "beleg", "futter", "interfac",
        "einlage"},
       {"pk", "pkt"},
       {"pocket", "tasche"}},
      // A hoodie is the garment, whatever piece of it.
      {&W::hood,
       {"hood", "kapuze", "capuche", "capucha"},
       {"ho"},
       {"kapuze"},
       {"hoodie", "hoody", "hooded", "kapuzenp", "kapuzenj"}},
      {&W::centre, {"center", "centre", "mitte", "centro", "gusset"}, {}, {}},
      {&W::neck,
       {"neck", "collar", "kragen", "hals", "col", "cuello"},
       {"co", "nr", "nb"},
       {"neck", "collar", "kragen", "hals"}},
      {&W::cuff,
       {"cuff", "manschette", "poignet", "puno", "polsino"},
       {"cu"},
       {"cuff", "manschette"}},
      {&W::waist,
       {"waistband", "bund", "ceinture", "cintura", "pretina"},
       {"wb"},
       {"waistband", "hosenbund"}},
      {&W::hem, {"hemband", "hemrib", "saumbund"}, {"hb"}, {"hemband", "saumbund"}},
      {&W::grain,
       {"grain", "fadenlauf", "warp", "droitfil", "hilo"},
       {"fl", "gl"},
       {"grain", "fadenlauf"}},
      {&W::fold,
       {"fold", "bruch", "stoffbruch", "mirrorline", "cutonfold", "onfold", "pliure", "doblez"},
       {"mirror"},
       {"onfold", "bruch"}},
      {&W::notch, {"notch", "knips", "cran", "piquete", "passzeichen"}, {}, {"notch"}},
      {&W::seam,
       {"sew", "seam", "naht", "stitch", "couture", "costura"},
       {},
       {"naht", "seamline", "sewline", "stitchline"}},
      {&W::hole,
       {"hole", "cutout", "aussparung", "opening", "oeffnung", "agujero", "hueco", "apertura",
        "abertura", "ouverture", "ausschnitt", "neckline", "encolure", "escote", "scollo"},
       {"loch", "trou", "buco", "foro", "furo", "buraco", "gat"},
       {"neckhole", "keyhole", "thumbhole", "halsloch", "halsausschnitt"}},
      {&W::sheet,
       {"control", "scale", "legend", "title", "frame", "page", "logo", "massstab", "rahmen",
        "kontroll", "calibration", "background"},
       {},
       {"testsquare"}},
  };
  return list;
}

/// What stands behind letters for the hand and for front or back that are written together with it,
/// as "sleeve" in "lfsleeve"; empty without them.
std::string behind_letters(const std::string& word, PieceWords& words) {
  if (word.size() < 5 || (word[0] != 'l' && word[0] != 'r')) return {};
  const auto names_a_piece = [](const std::string& rest) {
    const auto begins = [&](const char* k) { return rest.starts_with(k); };
    static constexpr const char* kPieces[] = {"front",  "back", "sleeve", "hood",
                                              "collar", "cuff", "pant",   "leg"};
    return std::any_of(std::begin(kPieces), std::end(kPieces), begins);
  };
  std::string rest = word.substr(1);
  bool front = false, back = false;
  if (!names_a_piece(rest)) {
    front = rest[0] == 'f', back = rest[0] == 'b';
    rest.erase(0, 1);
    if (!(front || back) || !names_a_piece(rest)) return {};
  }
  words.left |= word[0] == 'l', words.right |= word[0] == 'r';
  words.front |= front, words.back |= back;
  return rest;
}

bool says(const Known& known, const std::string& word) {
  const auto any = [&](const std::vector<const char*>& list, auto test) {
    return std::any_of(list.begin(), list.end(), test);
  };
  if (any(known.not_begins, [&](const char* k) { return word.starts_with(k); })) return false;
  return any(known.is, [&](const char* k) { return word == k; }) ||
         any(known.begins, [&](const char* k) { return word.starts_with(k); }) ||
         any(known.holds, [&](const char* k) { return word.find(k) != std::string::npos; });
}

}  // namespace

PieceWords words_of(const std::string& name) {
  PieceWords words;
  bool rt = false, mirrored = false, side = false, button = false, strip = false;
  bool test = false, square = false;
  for (const std::string& word : split(name.substr(0, 200))) {
    test |= word == "test", square |= word == "square" || word == "quadrat";
    rt |= word == "rt", mirrored |= word == "mirrored", side |= word == "side";
    button |= word.starts_with("button") || word.starts_with("knopf") || word == "drill";
    // "Neckline facing" is sewn to a neckline.
    for (const char* begins : {"facing", "beleg", "parement", "interfac", "interlin", "lining",
                               "futter", "einlage", "binding", "band", "bias", "rib"})
      strip |= word.starts_with(begins);
    const std::string rest = behind_letters(word, words);
    for (const Known& one : known())
      if (!word.empty() && (says(one, word) || (!rest.empty() && says(one, rest))))
        words.*one.what = true;
  }
  if (button || strip) words.hole = false;
  words.sheet |= test && square;
  // In German lists the back ("Rückenteil"), in those of CAD systems the right hand of something.
  if (rt) {
    const bool of_something = words.front || words.back || words.sleeve || words.leg ||
                              words.skirt || words.yoke || words.pocket || words.hood ||
                              words.neck || words.cuff || words.waist || side;
    (of_something ? words.right : words.back) = true;
  }
  // A twin keeps the name of the piece that it mirrors.
  if (mirrored) std::swap(words.left, words.right);
  // A back of trousers, not "Bruststück": names that say both say neither.
  if (words.left && words.right) words.left = words.right = false;
  if (words.front && words.back) words.front = words.back = false;
  return words;
}

bool names_a_piece(const PieceWords& w) {
  return w.front || w.back || w.sleeve || w.leg || w.skirt || w.yoke || w.pocket || w.hood ||
         w.neck || w.cuff || w.waist || w.hem;
}

bool names_cloth(const PieceWords& words) { return names_a_piece(words) || words.top; }

PieceWords words_of(const Panel& panel) {
  return words_of((panel.part.empty() ? panel.name : panel.part) + " " + panel.label);
}

}  // namespace loosefit::pattern
