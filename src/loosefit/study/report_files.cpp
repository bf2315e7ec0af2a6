#include "loosefit/study/report_files.h"

#include <fmt/format.h>

#include "loosefit/base/sha256.h"
#include "loosefit/io/plain_files.h"
#include "loosefit/io/text_file.h"
#include "loosefit/study/set_aside.h"
#include "loosefit/study/study_folder.h"

namespace loosefit::study {
namespace fs = std::filesystem;
namespace {

constexpr const char* kPage = "study-report.html";
constexpr const char* kDocument = "study-report.json";
constexpr std::size_t kLargestPage = 2000000000;

/// The last line of a page.
std::string mark_of(const std::string& html, const std::string& json_digest) {
  return fmt::format("<!-- Loosefit {} {} {} {} -->\n", kPage, sha256_hex(html), kDocument,
                     json_digest);
}

/// What the last line of the page that is there says of the document; empty without one.
struct MarkedPage {
  bool is_whole = false;  ///< the page is as it was written
  std::string json_digest;
};

MarkedPage page_in(const fs::path& folder) {
  if (io::standing(folder, kPage) != io::Standing::plain_file) return {};
  const std::string text = io::read_text_file((folder / kPage).string(), kLargestPage);
  const std::string begin = fmt::format("<!-- Loosefit {} ", kPage);
  const std::size_t at = text.rfind(begin), named = text.rfind(kDocument);
  if (at == std::string::npos || named == std::string::npos || named < at) return {};
  constexpr std::size_t kDigits = 64;
  MarkedPage page;
  const std::size_t from = named + std::string(kDocument).size() + 1;
  if (from > text.size()) return {};
  page.json_digest = text.substr(from, kDigits);
  page.is_whole = text.substr(at) == mark_of(text.substr(0, at), page.json_digest);
  return page;
}

}  // namespace

void write_report_files(const fs::path& folder, const std::string& html, const std::string& json,
                        const SetAside& tell) {
  for (const char* name : {kPage, kDocument}) remove_left_overs(folder / name);
  const MarkedPage before = page_in(folder);
  const std::string digest = sha256_hex(json);
  if (io::is_there(folder / kPage) && !before.is_whole) tell(set_aside(folder / kPage, "changed"));
  // The same text is what a killed process has left, or stood beside a page that was moved away.
  if (io::is_there(folder / kDocument))
    if (const auto there = io::plain_digest(folder, kDocument);
        there != before.json_digest && there != digest)
      tell(set_aside(folder / kDocument, "changed"));
  write_whole(folder / kDocument, json);
  write_whole(folder / kPage, html + mark_of(html, digest));
}

}  // namespace loosefit::study
