#include "loosefit/io/machine_text.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <string_view>
#include <vector>

namespace loosefit::io {
namespace {

constexpr std::size_t kRead = 4000, kFewest = 3, kMostOfWord = 12;

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool is_space(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }
bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

char large(char c) { return static_cast<char>(std::toupper(static_cast<unsigned char>(c))); }

bool is_number_sign(char c) {
  return is_digit(c) || is_space(c) || c == ',' || c == '-' || c == '+' || c == '.';
}

/// Instructions of two letters with their numbers. Labels, comments and encoded lines hold any
/// letters up to their end.
bool is_hpgl(std::string_view text) {
  constexpr std::string_view kKnown[] = {
      "IN", "DF", "SP", "PU", "PD", "PA", "PR", "IP", "IW", "SC", "VS", "RO", "LT", "PS",
      "BP", "NP", "PE", "LB", "CO", "PW", "PC", "CI", "AA", "AR", "SI", "SR", "DI", "DT",
      "EC", "FS", "PG", "WU", "QL", "SD", "SS", "CS", "TR", "MC", "RP", "AC", "EA", "ER"};
  std::size_t known = 0, moves = 0;
  bool parted = false;
  for (std::size_t at = 0; at < text.size();) {
    if (is_space(text[at]) || text[at] == ';') {
      parted = parted || text[at] == ';';
      ++at;
      continue;
    }
    if (at + 1 >= text.size()) break;
    const std::string name{large(text[at]), large(text[at + 1])};
    if (std::find(std::begin(kKnown), std::end(kKnown), name) == std::end(kKnown)) return false;
    ++known;
    moves += name == "PU" || name == "PD" || name == "PA" || name == "PR" || name == "PE";
    at += 2;
    if (name == "LB" || name == "CO" || name == "BP" || name == "PE" || name == "DT") {
      at = text.find_first_of(";\x03", at);
      if (at == std::string_view::npos) break;
      parted = true, ++at;
      continue;
    }
    while (at < text.size() && is_number_sign(text[at])) ++at;
    if (at < text.size() && text[at] != ';' && !is_letter(text[at])) return false;
  }
  return known >= kFewest && moves > 0 && parted;
}

/// Words of a letter and a number, without what stands in brackets or behind a semicolon.
std::vector<std::string> iso_words(std::string_view text) {
  std::vector<std::string> words;
  for (std::size_t at = 0; at < text.size();) {
    if (text[at] == '(') {
      at = std::min(text.find(')', at), text.size());
      at += at < text.size();
    } else if (text[at] == ';') {
      at = std::min(text.find_first_of("\r\n", at), text.size());
    } else if (is_space(text[at]) || text[at] == '%' || text[at] == '*') {
      ++at;
    } else if (is_letter(text[at])) {
      std::string word(1, large(text[at++]));
      while (at < text.size() && text[at] == ' ') ++at;
      while (at < text.size() && is_number_sign(text[at]) && !is_space(text[at]) &&
             text[at] != ',' && word.size() < kMostOfWord)
        word += text[at++];
      if (word.size() < 2) return {};
      words.push_back(word);
    } else {
      return {};
    }
  }
  return words;
}

/// "G01" as "G1".
std::string plain(const std::string& word) {
  std::size_t zeros = 1;
  while (zeros + 1 < word.size() && word[zeros] == '0' && is_digit(word[zeros + 1])) ++zeros;
  return word[0] + word.substr(zeros);
}

bool is_photoplot(std::string_view text) {
  return text.find("%FSLA") != std::string_view::npos ||
         text.find("%FSTA") != std::string_view::npos ||
         (text.find("%MOMM*%") != std::string_view::npos) ||
         (text.find("%MOIN*%") != std::string_view::npos);
}

}  // namespace

std::string machine_language(const std::string& all) {
  // The last word may be cut off.
  std::string_view text = std::string_view(all).substr(0, kRead);
  if (text.size() == kRead) text = text.substr(0, text.find_last_of(" ;*\r\n\t"));
  if (is_photoplot(text)) return "a photoplot (Gerber RS-274X)";
  if (is_hpgl(text)) return "a plot file (HPGL)";
  const std::vector<std::string> words = iso_words(text);
  std::size_t moves = 0, places = 0, tools = 0;
  for (const std::string& word : words) {
    const std::string code = plain(word);
    moves += code == "G0" || code == "G1" || code == "G2" || code == "G3" || code == "G21" ||
             code == "G20" || code == "G90" || code == "G91";
    places += code[0] == 'X' || code[0] == 'Y';
    tools += code == "M14" || code == "M15" || code == "M19" || code == "M20";
  }
  if (moves > 0 && words.size() >= kFewest) return "a machine program (G-code)";
  // Knife down and up are M14 and M15; a star ends every block.
  if (tools > 0 && places > 0 && text.find('*') != std::string_view::npos)
    return "a cutter file (Gerber, ISO 6983)";
  return {};
}

}  // namespace loosefit::io
