#pragma once
#include <cstddef>
#include <functional>
#include <string>

namespace loosefit {

/// Length of the UTF-8 sequence at `at` in bytes; 0 where there is none (RFC 3629).
std::size_t sequence_length(const std::string& text, std::size_t at);

/// The character that a sequence of UTF-8 is. \pre it is one
char32_t code_point(const std::string& sequence);

/// Text with every sequence replaced that moves the cursor, or turns or hides text (C0, DEL, C1,
/// zero-width and bidirectional marks, line separators, tags), and every byte that is not UTF-8.
/// `replaced` is asked for what stands in the place of such a sequence or byte.
std::string replace_controls(const std::string& text,
                             const std::function<std::string(const std::string&)>& replaced);

/// A JSON document in which none of them stands as it is: within texts, where alone they can be,
/// they become \u escapes, so a reader gets the same texts. Line ends between values stay.
/// \pre it is JSON in UTF-8.
std::string json_without_controls(const std::string& document);

}  // namespace loosefit
