#pragma once
#include <string>
#include <vector>

namespace loosefit {

/// Number of single-letter edits (insert, delete, replace, swap of neighbours) from a to b
/// (optimal string alignment, Damerau 1964). Case is ignored, '-' and '_' count as equal.
int edit_distance(const std::string& a, const std::string& b);

/// The candidate nearest to `word` when it is near enough to be a slip (at most a third of the
/// letters, never more than three); empty otherwise. Ties go to the earlier candidate.
std::string closest_match(const std::string& word, const std::vector<std::string>& candidates);

/// Hint for an unknown name: `did you mean "x"?` when one is near, else `known: a, b, c`.
std::string did_you_mean(const std::string& word, const std::vector<std::string>& candidates);

/// "a, b, c"
std::string join(const std::vector<std::string>& words, const std::string& separator = ", ");

/// Shortest decimal text that reads back to the same double: "0.1", "1e-06", "nan".
std::string shortest(double value);

/// Text for a terminal: control characters, invisible ones that turn or hide text (bidirectional
/// marks, zero-width spaces), and bytes that are not UTF-8 escaped (`\x1b`); all else as it is.
/// Line ends are escaped too, so that the text stays on its line.
std::string terminal_line(const std::string& text);
/// The same of several lines: line ends stay.
std::string terminal_text(const std::string& text);
/// The same for XML and HTML, where no escape exists: U+FFFD in place of what may not stand there;
/// tabs and line ends stay.
std::string without_controls(const std::string& text);

/// Whether all of it is UTF-8 (RFC 3629).
bool valid_utf8(const std::string& text);

/// Text for an error message: escaped as by terminal_line, line ends by their code; longer text
/// than `limit` bytes is cut after a whole letter.
std::string printable(const std::string& text, std::size_t limit = 60);

}  // namespace loosefit
