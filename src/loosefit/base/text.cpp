#include "loosefit/base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "loosefit/base/control_characters.h"

namespace loosefit {
namespace {

char folded(char c) {
  return c == '-' ? '_' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
}

std::string escaped_bytes(const std::string& bytes) {
  std::string shown;
  for (char c : bytes) shown += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
  return shown;
}

}  // namespace

int edit_distance(const std::string& a, const std::string& b) {
  const std::size_t n = a.size(), m = b.size();
  std::vector<int> before(m + 1), above(m + 1), row(m + 1);
  for (std::size_t j = 0; j <= m; ++j) above[j] = static_cast<int>(j);
  for (std::size_t i = 1; i <= n; ++i) {
    row[0] = static_cast<int>(i);
    for (std::size_t j = 1; j <= m; ++j) {
      const bool same = folded(a[i - 1]) == folded(b[j - 1]);
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + (same ? 0 : 1)});
      if (i > 1 && j > 1 && folded(a[i - 1]) == folded(b[j - 2]) &&
          folded(a[i - 2]) == folded(b[j - 1]))
        row[j] = std::min(row[j], before[j - 2] + 1);
    }
    before.swap(above);
    above.swap(row);
  }
  return above[m];
}

std::string closest_match(const std::string& word, const std::vector<std::string>& candidates) {
  if (word.size() > 64) return {};  // no slip of the finger is that long
  const int allowed = std::clamp(static_cast<int>(word.size()) / 3, 1, 3);
  std::string best;
  int best_distance = allowed + 1;
  for (const std::string& candidate : candidates) {
    const int distance = edit_distance(word, candidate);
    if (distance < best_distance) {
      best_distance = distance;
      best = candidate;
    }
  }
  return best;
}

std::string did_you_mean(const std::string& word, const std::vector<std::string>& candidates) {
  const std::string near = closest_match(word, candidates);
  if (!near.empty()) return "did you mean \"" + near + "\"?";
  return candidates.empty() ? std::string() : "known: " + join(candidates);
}

std::string join(const std::vector<std::string>& words, const std::string& separator) {
  std::string text;
  for (const std::string& word : words) {
    if (!text.empty()) text += separator;
    text += word;
  }
  return text;
}

std::string shortest(double value) { return fmt::format("{}", value); }

std::string terminal_line(const std::string& text) {
  return replace_controls(
      text, [](const std::string& s) { return s == "\n" ? "\\n" : escaped_bytes(s); });
}

std::string terminal_text(const std::string& text) {
  return replace_controls(text,
                          [](const std::string& s) { return s == "\n" ? s : escaped_bytes(s); });
}

std::string without_controls(const std::string& text) {
  return replace_controls(text, [](const std::string& s) {
    return s == "\n" || s == "\t" || s == "\r" ? s : std::string("\ufffd");
  });
}

bool valid_utf8(const std::string& text) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = sequence_length(text, at);
    if (length == 0) return false;
    at += length;
  }
  return true;
}

std::string printable(const std::string& text, std::size_t limit) {
  std::size_t end = std::min(limit, text.size());
  // A letter of several bytes stays whole.
  for (int k = 0; k < 3 && end < text.size() && end > 0 && (text[end] & 0xc0) == 0x80; ++k) --end;
  const std::string shown = replace_controls(text.substr(0, end), escaped_bytes);
  return end < text.size() ? shown + "..." : shown;
}

}  // namespace loosefit
