#pragma once
#include <source_location>

/// The three kinds of check, by who is wrong and what the check costs:
///
/// | who is wrong                           | checked                         | how              |
/// |----------------------------------------|---------------------------------|------------------|
/// | the user: bad input                    | always                          | InvalidInput     |
/// | the program: wrong use or wrong state  | always; once a call, not a loop | require          |
/// | the program: a stated precondition     | debug and sanitizer builds      | LOOSEFIT_ASSERT  |
///
/// InvalidInput (base/error.h) names file, line and key for the user. The other two name the place
/// in the source for the developer. Every `\pre` of a header is checked by LOOSEFIT_ASSERT; a
/// demand that nothing can check (what a reference refers to lives longer) is stated without \pre.

/// 1 where LOOSEFIT_ASSERT checks: in debug builds (no NDEBUG) and sanitizer builds, which are the
/// presets debug and asan.
#ifndef LOOSEFIT_CHECKED
#if !defined(NDEBUG) || defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define LOOSEFIT_CHECKED 1
#else
#define LOOSEFIT_CHECKED 0
#endif
#endif

/// Ends the program with expression, file and line on stderr when the expression is false, so that
/// a debugger or sanitizer shows the stack. Where it does not check, the expression is compiled but
/// not evaluated.
#if LOOSEFIT_CHECKED
#define LOOSEFIT_ASSERT(...) \
  ((__VA_ARGS__) ? void() : ::loosefit::assertion_failed(#__VA_ARGS__, __FILE__, __LINE__))
#else
#define LOOSEFIT_ASSERT(...) static_cast<void>(sizeof((__VA_ARGS__) ? 1 : 0))
#endif

namespace loosefit {

/// \throws Error "internal error: EXPECTED does not hold (FILE:LINE)" when `holds` is false.
/// `expected` is what must be true, in words.
void require(bool holds, const char* expected,
             std::source_location here = std::source_location::current());

/// What LOOSEFIT_ASSERT calls.
[[noreturn]] void assertion_failed(const char* expression, const char* file, int line);

}  // namespace loosefit
