#pragma once

namespace loosefit::report {

/// The style sheet of the report page.
extern const char* const kReportStyle;

}  // namespace loosefit::report
