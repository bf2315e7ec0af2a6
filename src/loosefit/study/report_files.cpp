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
  page.json_digest = text.substr(named + std::string(kDocument).size() + 1, kDigits);
  page.is_whole = text.substr(at) == mark_of(text.substr(0, at), page.json_digest);
  return page;
}

}  // namespace

std::vector<fs::path> write_report_files(const fs::path& folder, const std::string& html,
                                         const std::string& json) {
  const MarkedPage before = page_in(folder);
  std::vector<fs::path> aside;
  if (io::is_there(folder / kPage) && !before.is_whole)
    aside.push_back(set_aside(folder / kPage, "changed"));
  if (io::is_there(folder / kDocument) && io::plain_digest(folder, kDocument) != before.json_digest)
    aside.push_back(set_aside(folder / kDocument, "changed"));
  // The page last: it speaks of both.
  write_whole(folder / kDocument, json);
  write_whole(folder / kPage, html + mark_of(html, sha256_hex(json)));
  return aside;
}

}  // namespace loosefit::study
