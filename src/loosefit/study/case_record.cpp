#include "loosefit/study/case_record.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "loosefit/base/build_id.h"
#include "loosefit/base/control_characters.h"
#include "loosefit/base/error.h"
#include "loosefit/base/sha256.h"
#include "loosefit/io/text_file.h"

namespace loosefit::study {
namespace {

using Json = nlohmann::json;

constexpr const char* kFormat = "loosefit-case 1";
constexpr std::size_t kLargestRecord = 200000000;

Json number_or_null(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

double number_or_null(const Json& json) { return json.is_null() ? kNotKnown : json.get<double>(); }

Json numbers(const std::map<std::string, double>& values) {
  Json json = Json::object();
  for (const auto& [key, value] : values) json[key] = number_or_null(value);
  return json;
}

std::map<std::string, double> numbers(const Json& json) {
  std::map<std::string, double> values;
  for (const auto& [key, value] : json.items()) values[key] = number_or_null(value);
  return values;
}

Json site_json(const SiteRecord& s) {
  return {{"modality", s.modality},      {"site", s.site},
          {"region", s.region},          {"panel", s.panel},
          {"at_m", {s.u, s.v}},          {"position_m", {s.x, s.y, s.z}},
          {"not_covered", s.not_covered}};
}

SiteRecord site_of(const Json& j) {
  SiteRecord s;
  s.modality = j.at("modality");
  s.site = j.at("site");
  s.region = j.at("region");
  s.panel = j.at("panel");
  s.u = j.at("at_m").at(0);
  s.v = j.at("at_m").at(1);
  s.x = j.at("position_m").at(0);
  s.y = j.at("position_m").at(1);
  s.z = j.at("position_m").at(2);
  s.not_covered = j.at("not_covered");
  return s;
}

Json sample_json(const SampleRecord& s) {
  return {{"modality", s.modality},
          {"site", s.site},
          {"donning", s.donning},
          {"score", number_or_null(s.score)},
          {"margin", number_or_null(s.margin)},
          {"bound", number_or_null(s.bound)},
          {"limiting", s.limiting},
          {"reason", s.reason},
          {"metrics", numbers(s.metrics)}};
}

SampleRecord sample_of(const Json& j) {
  SampleRecord s;
  s.modality = j.at("modality");
  s.site = j.at("site");
  s.donning = j.at("donning");
  s.score = number_or_null(j.at("score"));
  s.margin = number_or_null(j.at("margin"));
  s.bound = number_or_null(j.at("bound"));
  s.limiting = j.at("limiting");
  s.reason = j.at("reason");
  s.metrics = numbers(j.at("metrics"));
  return s;
}

Json result_json(const CaseRecord& r) {
  Json json = {{"format", kFormat},
               {"address", r.address},
               {"status", name(r.status)},
               {"reason", r.reason},
               {"residual", number_or_null(r.residual)},
               {"vertices", r.vertices},
               {"triangles", r.triangles},
               {"drapes_asked", r.drapes_asked},
               {"drapes_counted", r.drapes_counted},
               {"left_out", r.left_out},
               {"warnings", r.warnings},
               {"body_m", numbers(r.body)},
               {"fit", numbers(r.fit)},
               {"garment", numbers(r.garment)},
               {"maps", Json::object()},
               {"untold", r.untold},
               {"sites", Json::array()},
               {"samples", Json::array()},
               {"versions", r.versions},
               {"execution",
                {{"seconds", number_or_null(r.execution.seconds)},
                 {"peak_memory_mb", number_or_null(r.execution.peak_memory_mb)},
                 {"host", r.execution.host}}}};
  for (const auto& [array, values] : r.maps) json["maps"][array] = numbers(values);
  for (const SiteRecord& s : r.sites) json["sites"].push_back(site_json(s));
  for (const SampleRecord& s : r.samples) json["samples"].push_back(sample_json(s));
  return json;
}

CaseStatus status_of(const std::string& word) {
  for (const CaseStatus status : {CaseStatus::done, CaseStatus::sealed, CaseStatus::failed})
    if (word == name(status)) return status;
  throw InvalidInput("unknown status " + word);
}

CaseRecord result_of(const Json& j) {
  if (j.at("format") != kFormat) throw InvalidInput("another format");
  CaseRecord r;
  r.address = j.at("address");
  r.status = status_of(j.at("status"));
  r.reason = j.at("reason");
  r.residual = number_or_null(j.at("residual"));
  r.vertices = j.at("vertices");
  r.triangles = j.at("triangles");
  r.drapes_asked = j.at("drapes_asked");
  r.drapes_counted = j.at("drapes_counted");
  r.left_out = j.at("left_out").get<std::vector<std::string>>();
  r.warnings = j.at("warnings").get<std::vector<std::string>>();
  r.body = numbers(j.at("body_m"));
  r.fit = numbers(j.at("fit"));
  r.garment = numbers(j.at("garment"));
  for (const auto& [array, values] : j.at("maps").items()) r.maps[array] = numbers(values);
  r.untold = j.at("untold").get<std::map<std::string, std::vector<std::string>>>();
  for (const Json& s : j.at("sites")) r.sites.push_back(site_of(s));
  for (const Json& s : j.at("samples")) r.samples.push_back(sample_of(s));
  r.versions = j.at("versions").get<std::map<std::string, std::string>>();
  r.execution.seconds = number_or_null(j.at("execution").at("seconds"));
  r.execution.peak_memory_mb = number_or_null(j.at("execution").at("peak_memory_mb"));
  r.execution.host = j.at("execution").at("host");
  return r;
}

}  // namespace

const char* name(CaseStatus status) {
  switch (status) {
    case CaseStatus::done:
      return "done";
    case CaseStatus::sealed:
      return "sealed";
    case CaseStatus::failed:
      return "failed";
  }
  return "?";
}

bool is_scored(const CaseRecord& record) {
  return record.status == CaseStatus::done &&
         std::ranges::any_of(record.samples,
                             [](const SampleRecord& sample) { return !std::isnan(sample.margin); });
}

bool of_another_build(const CaseRecord& record) {
  const auto build = record.versions.find("build");
  return build == record.versions.end() || build->second != build_id();
}

std::string record_json(const CaseRecord& record) {
  // What is dumped is digested; bytes that are not UTF-8 (of a path in a message) are replaced.
  const std::string result = json_without_controls(
      result_json(record).dump(1, ' ', false, Json::error_handler_t::replace));
  return "{\"sha256\": \"" + sha256_hex(result) + "\",\n\"result\": " + result + "}\n";
}

CaseRecord parse_record(const std::string& text, const std::string& file) try {
  constexpr std::string_view kHead = "{\"sha256\": \"", kNext = "\",\n\"result\": ", kTail = "}\n";
  constexpr std::size_t kDigest = 64, kBegin = kHead.size() + kDigest + kNext.size();
  if (text.size() < kBegin + kTail.size() || text.compare(0, kHead.size(), kHead) != 0 ||
      text.compare(text.size() - kTail.size(), kTail.size(), kTail) != 0)
    throw InvalidInput({file, 0, ""}, "half a file", "the result of a case");
  const std::string result = text.substr(kBegin, text.size() - kBegin - kTail.size());
  if (sha256_hex(result) != text.substr(kHead.size(), kDigest))
    throw InvalidInput({file, 0, "sha256"}, "another text than was written",
                       "the result of a case as the program wrote it");
  return result_of(Json::parse(result));
} catch (const Json::exception& error) {
  throw InvalidInput({file, 0, ""}, error.what(), "the result of a case");
}

std::optional<CaseRecord> read_record(const std::filesystem::path& file,
                                      const std::string& address) {
  // What cannot be looked at may be a result: it is neither missing nor to be run again.
  std::error_code error;
  const auto there = std::filesystem::status(file, error);
  if (there.type() == std::filesystem::file_type::not_found) return {};
  if (there.type() == std::filesystem::file_type::none)
    throw IoError(file.string() + ": cannot be read: " + error.message());
  try {
    CaseRecord record =
        parse_record(io::read_text_file(file.string(), kLargestRecord), file.string());
    if (record.address == address) return record;
  } catch (const InvalidInput&) {
    // Not whole: as if it were not there.
  }
  return {};
}

}  // namespace loosefit::study
