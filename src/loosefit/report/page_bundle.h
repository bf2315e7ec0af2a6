#pragma once
#include <string_view>

namespace loosefit::report {

/// Script and style of the interactive part of a report, as web/ was built into this program; both
/// empty where it could not be built (tools/build_page.sh).
std::string_view page_script();
std::string_view page_style();

}  // namespace loosefit::report
