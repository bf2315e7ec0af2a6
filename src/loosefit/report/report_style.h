#pragma once

namespace loosefit {

/// The style sheet of the report page.
extern const char* const kReportStyle;

}  // namespace loosefit
