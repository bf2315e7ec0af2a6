#pragma once
#include <algorithm>
#include <random>
#include <string>
#include <vector>

namespace loosefit {

/// Damages a text in one of the ways files get damaged: bytes changed, cut off, lines deleted,
/// doubled or swapped, keys misspelt, values replaced by other types and extreme numbers.
class Mutator {
 public:
  explicit Mutator(unsigned seed) : random_(seed) {}

  std::string operator()(std::string text) {
    for (int i = pick(3); i >= 0; --i) text = once(std::move(text));
    return text;
  }

 private:
  /// 0 … n-1; the same on every machine, unlike std::uniform_int_distribution.
  int pick(std::size_t n) { return n == 0 ? 0 : static_cast<int>(random_() % n); }

  std::string once(std::string text) {
    static const std::vector<std::string> kValues = {
        "nan",         "inf",
        "-inf",        "1e308",
        "-1e308",      "1e-308",
        "0",           "-1",
        "168",         "9223372036854775807",
        "true",        "\"\"",
        "\"x\"",       "[]",
        "[[]]",        "{}",
        "{ a = 1 }",   "1979-05-27",
        "[1, 2]",      "[nan, 1]",
        "\"\\u0000\"", "9999999999999999999999",
        "'''",         "[[[[[[[[",
    };
    std::vector<std::string> lines = split(text);
    switch (pick(9)) {
      case 0:
        return text.substr(0, pick(text.size() + 1));
      case 1:
        for (int i = 1 + pick(8); i > 0 && !text.empty(); --i)
          text[pick(text.size())] = static_cast<char>(pick(256));
        return text;
      case 2:
        lines.erase(lines.begin() + pick(lines.size()));
        return joined(lines);
      case 3:
        lines.insert(lines.begin() + pick(lines.size()), lines[pick(lines.size())]);
        return joined(lines);
      case 4:
        std::swap(lines[pick(lines.size())], lines[pick(lines.size())]);
        return joined(lines);
      case 5: {  // another value for a key
        std::string& line = lines[pick(lines.size())];
        const std::size_t equals = line.find('=');
        if (equals != std::string::npos)
          line = line.substr(0, equals + 1) + " " + kValues[pick(kValues.size())];
        return joined(lines);
      }
      case 6: {  // a misspelt key
        std::string& line = lines[pick(lines.size())];
        if (!line.empty()) line.erase(pick(std::min<std::size_t>(line.size(), 12)), 1);
        return joined(lines);
      }
      case 7: {  // another number somewhere
        const std::size_t digit = text.find_first_of("0123456789", pick(text.size() + 1));
        if (digit != std::string::npos) text.replace(digit, 1, kValues[pick(6)]);
        return text;
      }
      default: {
        const std::size_t at = pick(text.size() + 1);
        return text.insert(at, kValues[pick(kValues.size())]);
      }
    }
  }

  static std::vector<std::string> split(const std::string& text) {
    std::vector<std::string> lines(1);
    for (char c : text) {
      if (c == '\n')
        lines.emplace_back();
      else
        lines.back() += c;
    }
    return lines;
  }

  static std::string joined(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    return text;
  }

  std::mt19937 random_;
};

}  // namespace loosefit
