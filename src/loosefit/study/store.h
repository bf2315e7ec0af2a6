#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "loosefit/study/database.h"
#include "loosefit/study/study_folder.h"

namespace loosefit::study {

/// The database of a study, study.sqlite (schema: docs/studies.md 4). It holds what plan.json and
/// the results of the cases say and can always be made from them again; its rows, sorted by their
/// keys, do not depend on the order in which cases have run, nor on where. One transaction a case:
/// several processes may write.
class Store {
 public:
  /// Opens or makes it; an empty name: one for this process alone. \throws IoError
  explicit Store(const std::filesystem::path& file);
  const Database& database() const { return database_; }

  /// Makes study, axes, inputs and cases those of the plan and removes what belongs to no case of
  /// it. Cases of the same address are the same case under several numbers.
  void put_plan(const FolderPlan& plan);
  /// Takes a result in, in place of an earlier one, for every number with its address.
  void put(const FolderPlan& plan, const CaseRecord& record);
  /// Takes a result out; its cases are open again.
  void forget(const std::string& address);
  /// Addresses whose results are in it.
  std::vector<std::string> addresses() const;

 private:
  Database database_;
};

/// Brings a database, wherever it lies, up to the results of a folder, of which nothing is changed.
/// \throws DamagedDatabase, IoError
void bring_up(Store& store, const StudyFolder& folder, const FolderPlan& plan);

/// Brings the database of a folder up to its results: what is missing goes in, what has no result
/// any more goes out. What has its name and is no such database, or a damaged one, is set aside as
/// study.sqlite.damaged-1, …, and made anew. \throws IoError
void collect(const StudyFolder& folder, const FolderPlan& plan);

/// Names of the tables, in the order of the documentation.
const std::vector<std::string>& table_names();

/// SHA-256 over all rows of all tables but `execution`, which says how long and where.
std::string content_sha256(const Database& database);
std::string content_sha256(const std::filesystem::path& database);

/// Writes every table as CSV (RFC 4180) into a folder, all or none, in the place of nothing but
/// an earlier export (io/run_folder.h); returns the names of the files. \throws IoError,
/// InvalidInput.
std::vector<std::string> export_csv(const Database& database, const std::filesystem::path& folder);
std::vector<std::string> export_csv(const std::filesystem::path& database,
                                    const std::filesystem::path& folder);

}  // namespace loosefit::study
