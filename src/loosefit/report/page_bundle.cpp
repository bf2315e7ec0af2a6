#include "loosefit/report/page_bundle.h"

// Holds their checksums: a compiler's cache would not see that what .incbin names has changed.
#include LOOSEFIT_PAGE_STAMP

// They stand here as they are, between labels of their own.
asm(".section .rodata\n"
    ".global loosefit_page_script, loosefit_page_script_end\n"
    ".global loosefit_page_style, loosefit_page_style_end\n"
    ".hidden loosefit_page_script, loosefit_page_script_end\n"
    ".hidden loosefit_page_style, loosefit_page_style_end\n"
    "loosefit_page_script:\n"
    ".incbin \"" LOOSEFIT_PAGE_DIR "/page.js\"\n"
    "loosefit_page_script_end:\n"
    "loosefit_page_style:\n"
    ".incbin \"" LOOSEFIT_PAGE_DIR "/page.css\"\n"
    "loosefit_page_style_end:\n"
    ".byte 0\n"
    ".previous\n");

extern "C" {
extern const char loosefit_page_script[] __attribute__((visibility("hidden")));
extern const char loosefit_page_script_end[] __attribute__((visibility("hidden")));
extern const char loosefit_page_style[] __attribute__((visibility("hidden")));
extern const char loosefit_page_style_end[] __attribute__((visibility("hidden")));
}

namespace loosefit::report {

std::string_view page_script() {
  return {loosefit_page_script,
          static_cast<std::size_t>(loosefit_page_script_end - loosefit_page_script)};
}

std::string_view page_style() {
  return {loosefit_page_style,
          static_cast<std::size_t>(loosefit_page_style_end - loosefit_page_style)};
}

}  // namespace loosefit::report
