#pragma once
#include <string_view>

namespace loosefit {

/// Prints what there is to say besides. That nobody can read it, as of a terminal that is gone or a
/// full disk, ends no work: fmt::print would throw.
void to_standard_error(std::string_view text) noexcept;

}  // namespace loosefit
