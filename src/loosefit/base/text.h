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

/// Text for an error message: control characters and bytes outside ASCII escaped, long text cut.
std::string printable(const std::string& text, std::size_t limit = 60);

}  // namespace loosefit
