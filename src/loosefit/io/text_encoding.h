#pragma once
#include <string>
#include <string_view>

namespace loosefit::io {

/// Text of a file of any editor as UTF-8 without a byte order mark. UTF-16 is told by its mark, or
/// by zeros in every other byte of its beginning. Line ends CR alone become LF where the text has
/// no LF. Text in a code page and bytes that are no text stay as they are.
std::string plain_text(std::string bytes);

/// A number as programs of any country write it, blanks round it left out: "1.68", "+2", "1e-3",
/// and, as there is one comma and no point in it, "1,68". For words that no comma can part.
/// \return whether all of it is a finite number
bool number_in(std::string_view text, double& value);

}  // namespace loosefit::io
