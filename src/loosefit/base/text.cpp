#include "loosefit/base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <functional>

namespace loosefit {
namespace {

char folded(char c) {
  return c == '-' ? '_' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
}

/// Length of the UTF-8 sequence at `at` in bytes; 0 where there is none (RFC 3629).
std::size_t sequence_length(const std::string& text, std::size_t at) {
  const auto byte = [&](std::size_t i) -> unsigned char {
    return at + i < text.size() ? static_cast<unsigned char>(text[at + i]) : 0;
  };
  const unsigned char first = byte(0);
  if (first < 0x80) return 1;
  const std::size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  if (first < 0xc2 || first > 0xf4) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(i) & 0xc0) != 0x80) return 0;
  const bool overlong = (first == 0xe0 && byte(1) < 0xa0) || (first == 0xf0 && byte(1) < 0x90);
  const bool surrogate = first == 0xed && byte(1) > 0x9f, beyond = first == 0xf4 && byte(1) > 0x8f;
  return overlong || surrogate || beyond ? 0 : length;
}

/// Whether a sequence moves the cursor, or turns or hides text: C0, DEL and C1, zero-width and
/// bidirectional marks, line separators, byte order marks.
bool is_control(const std::string& s) {
  const unsigned char first = static_cast<unsigned char>(s[0]);
  if (s.size() == 1) return first < 0x20 || first == 0x7f;
  if (s.size() == 2) return first == 0xc2 && static_cast<unsigned char>(s[1]) < 0xa0;
  return (s >= "\u200b" && s <= "\u200f") || (s >= "\u2028" && s <= "\u202e") ||
         (s >= "\u2060" && s <= "\u2069") || s == "\ufeff";
}

/// Text with every control sequence and every byte that is not UTF-8 replaced.
std::string with_controls(const std::string& text,
                          const std::function<std::string(const std::string&)>& replaced) {
  std::string shown;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = sequence_length(text, at);
    const std::string sequence = text.substr(at, std::max<std::size_t>(length, 1));
    shown += length == 0 || is_control(sequence) ? replaced(sequence) : sequence;
    at += sequence.size();
  }
  return shown;
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
  return with_controls(text,
                       [](const std::string& s) { return s == "\n" ? "\\n" : escaped_bytes(s); });
}

std::string terminal_text(const std::string& text) {
  return with_controls(text, [](const std::string& s) { return s == "\n" ? s : escaped_bytes(s); });
}

std::string without_controls(const std::string& text) {
  return with_controls(text, [](const std::string& s) {
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
  std::string shown;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (i >= limit) return shown + "...";
    const unsigned char c = static_cast<unsigned char>(text[i]);
    if (c >= 0x20 && c < 0x7f)
      shown += text[i];
    else
      shown += fmt::format("\\x{:02x}", c);
  }
  return shown;
}

}  // namespace loosefit
