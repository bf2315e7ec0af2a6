#pragma once
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

// What is kept of a case of a study: plain numbers, as they go into the database, and the file
// result.json of its folder.
namespace loosefit::study {

inline constexpr double kNotKnown = std::numeric_limits<double>::quiet_NaN();

/// A sensor at a site of one garment.
struct SiteRecord {
  std::string modality, site;
  std::string region, panel;
  double u = 0, v = 0;           ///< in the pattern [m]
  double x = 0, y = 0, z = 0;    ///< as worn in the reference posture [m]
  std::string not_covered = {};  ///< why there is no skin under it; then no samples
};

/// What that sensor meets in one donning.
struct SampleRecord {
  std::string modality, site;
  int donning = 1;
  double score = kNotKnown;  ///< 0 … 1; NaN: not rated
  double margin = kNotKnown, bound = 1;
  std::string limiting;  ///< metric that limits it
  std::string reason;    ///< in words
  std::map<std::string, double> metrics;
};

/// How a case ended.
enum class CaseStatus {
  done,
  sealed,  ///< the drape did not settle or is not worn
  failed   ///< an error: bad geometry, no body of these measures, …
};
const char* name(CaseStatus status);

/// What has no influence on results.
struct Execution {
  double seconds = 0;
  double peak_memory_mb = 0;
  std::string host;
};

struct CaseRecord {
  std::string address;
  CaseStatus status = CaseStatus::failed;
  std::string reason;  ///< of sealed and failed cases
  double residual = kNotKnown;
  int vertices = 0, triangles = 0;
  int drapes_asked = 0, drapes_counted = 0;  ///< states: postures × donnings
  std::vector<std::string> left_out;         ///< states that do not count, and why
  std::vector<std::string> warnings;
  std::map<std::string, double> body;     ///< measured [m]
  std::map<std::string, double> fit;      ///< BGM as cut, by station
  std::map<std::string, double> garment;  ///< figures of the whole garment, units in the names
  std::map<std::string, std::map<std::string, double>> maps;  ///< array → statistic → value
  /// Criteria of a modality that this scenario cannot tell, by scorecard: its scores are upper
  /// bounds.
  std::map<std::string, std::vector<std::string>> untold;
  std::vector<SiteRecord> sites;
  std::vector<SampleRecord> samples;
  std::map<std::string, std::string> versions;
  Execution execution;
};

/// Whether a sample of it is rated, by any modality.
bool is_scored(const CaseRecord& record);

/// Whether a build of the program other than this one made it (base/build_id.h).
bool of_another_build(const CaseRecord& record);

/// JSON with its own SHA-256: what a process has left behind is whole or told from it. Numbers are
/// written so that they read back as the same bits.
std::string record_json(const CaseRecord& record);

/// \throws InvalidInput for text that is not whole, was changed, or is of another format.
CaseRecord parse_record(const std::string& text, const std::string& file);

/// result.json of a case's folder; nothing when there is none, or none that is whole and of this
/// address: the case then counts as not run. \throws IoError when it cannot be looked at.
std::optional<CaseRecord> read_record(const std::filesystem::path& file,
                                      const std::string& address);

}  // namespace loosefit::study
