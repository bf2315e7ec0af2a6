#include "loosefit/study/store.h"

#include <algorithm>
#include <map>
#include <set>

#include "loosefit/base/error.h"
#include "loosefit/base/sha256.h"
#include "loosefit/base/text.h"
#include "loosefit/io/csv.h"
#include "loosefit/io/plain_files.h"
#include "loosefit/io/run_folder.h"
#include "loosefit/io/text_file.h"
#include "loosefit/study/set_aside.h"

namespace loosefit::study {
namespace fs = std::filesystem;
namespace {

constexpr int kSchema = 1;

const char* const kTables = R"sql(
CREATE TABLE IF NOT EXISTS study (key TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID;
CREATE TABLE IF NOT EXISTS axes (axis TEXT NOT NULL, position INTEGER NOT NULL, kind TEXT NOT NULL,
  sampled INTEGER NOT NULL, PRIMARY KEY (axis)) WITHOUT ROWID;
CREATE TABLE IF NOT EXISTS cases (number INTEGER PRIMARY KEY, address TEXT NOT NULL,
  status TEXT NOT NULL, reason TEXT, residual REAL, vertices INTEGER,
  triangles INTEGER, drapes INTEGER NOT NULL, drapes_counted INTEGER, edge_length_m REAL);
CREATE INDEX IF NOT EXISTS cases_by_address ON cases (address);
CREATE TABLE IF NOT EXISTS levels (number INTEGER NOT NULL, axis TEXT NOT NULL,
  level INTEGER NOT NULL, label TEXT NOT NULL, value REAL,
  PRIMARY KEY (number, axis)) WITHOUT ROWID;
CREATE TABLE IF NOT EXISTS inputs (number INTEGER NOT NULL, input TEXT NOT NULL,
  value REAL NOT NULL, PRIMARY KEY (number, input)) WITHOUT ROWID;
CREATE TABLE IF NOT EXISTS body (number INTEGER NOT NULL, measure TEXT NOT NULL, value_m REAL,
  PRIMARY KEY (number, measure)) WITHOUT ROWID;
CREATE TABLE IF NOT EXISTS fit (number INTEGER NOT NULL, station TEXT NOT NULL, bgm REAL,
  PRIMARY KEY (number, station)) WITHOUT ROWID;
CREATE TABLE IF NOT EXISTS garment (number INTEGER NOT NULL, quantity TEXT NOT NULL, value REAL,
  PRIMARY KEY (number, quantity)) WITHOUT ROWID;
CREATE TABLE IF NOT EXISTS maps (number INTEGER NOT NULL, array TEXT NOT NULL,
  statistic TEXT NOT NULL, value REAL, PRIMARY KEY (number, array, statistic)) WITHOUT ROWID;
CREATE TABLE IF NOT EXISTS sites (number INTEGER NOT NULL, modality TEXT NOT NULL,
  site TEXT NOT NULL, region TEXT, panel TEXT, u_m REAL, v_m REAL, x_m REAL, y_m REAL, z_m REAL,
  not_covered TEXT, PRIMARY KEY (number, modality, site)) WITHOUT ROWID;
CREATE TABLE IF NOT EXISTS samples (number INTEGER NOT NULL, modality TEXT NOT NULL,
  site TEXT NOT NULL, donning INTEGER NOT NULL, score REAL, margin REAL, bound REAL,
  limiting TEXT, reason TEXT, PRIMARY KEY (number, modality, site, donning)) WITHOUT ROWID;
CREATE TABLE IF NOT EXISTS metrics (number INTEGER NOT NULL, modality TEXT NOT NULL,
  site TEXT NOT NULL, donning INTEGER NOT NULL, metric TEXT NOT NULL, value REAL,
  PRIMARY KEY (number, modality, site, donning, metric)) WITHOUT ROWID;
CREATE TABLE IF NOT EXISTS notes (number INTEGER NOT NULL, kind TEXT NOT NULL,
  position INTEGER NOT NULL, text TEXT NOT NULL, PRIMARY KEY (number, kind, position)) WITHOUT ROWID;
CREATE TABLE IF NOT EXISTS versions (number INTEGER NOT NULL, library TEXT NOT NULL,
  version TEXT NOT NULL, PRIMARY KEY (number, library)) WITHOUT ROWID;
CREATE TABLE IF NOT EXISTS execution (number INTEGER PRIMARY KEY, seconds REAL,
  peak_memory_mb REAL, host TEXT);
)sql";

/// Those that hold what a case has yielded, with its number.
const std::vector<std::string>& result_tables() {
  static const std::vector<std::string> kNames = {"body",     "fit",      "garment", "maps",
                                                  "sites",    "samples",  "metrics", "notes",
                                                  "versions", "execution"};
  return kNames;
}

constexpr const char* kOpen = "open";  ///< status of a case that has not run

void forget_results(const Database& database, int number) {
  for (const std::string& table : result_tables())
    database.prepare("DELETE FROM " + table + " WHERE number = ?1").bind(1, number).run();
}

void put_pairs(const Database& database, const std::string& sql, int number,
               const std::map<std::string, double>& values) {
  Statement statement = database.prepare(sql);
  for (const auto& [key, value] : values)
    statement.bind(1, number).bind(2, key).bind(3, value).run();
}

void put_record(const Database& database, int number, const CaseRecord& r) {
  forget_results(database, number);
  database
      .prepare(
          "UPDATE cases SET status = ?2, reason = ?3, residual = ?4, vertices = ?5, "
          "triangles = ?6, drapes_counted = ?7 WHERE number = ?1")
      .bind(1, number)
      .bind(2, std::string(name(r.status)))
      .bind(3, r.reason)
      .bind(4, r.residual)
      .bind(5, r.vertices)
      .bind(6, r.triangles)
      .bind(7, r.drapes_counted)
      .run();
  put_pairs(database, "INSERT INTO body VALUES (?1, ?2, ?3)", number, r.body);
  put_pairs(database, "INSERT INTO fit VALUES (?1, ?2, ?3)", number, r.fit);
  put_pairs(database, "INSERT INTO garment VALUES (?1, ?2, ?3)", number, r.garment);
  Statement maps = database.prepare("INSERT INTO maps VALUES (?1, ?2, ?3, ?4)");
  for (const auto& [array, values] : r.maps)
    for (const auto& [statistic, value] : values)
      maps.bind(1, number).bind(2, array).bind(3, statistic).bind(4, value).run();
  // A site may be told of twice, found and not covered; the first counts.
  Statement sites = database.prepare(
      "INSERT OR IGNORE INTO sites VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7, ?8, ?9, ?10, ?11)");
  for (const SiteRecord& s : r.sites)
    sites.bind(1, number)
        .bind(2, s.modality)
        .bind(3, s.site)
        .bind(4, s.region)
        .bind(5, s.panel)
        .bind(6, s.u)
        .bind(7, s.v)
        .bind(8, s.x)
        .bind(9, s.y)
        .bind(10, s.z)
        .bind(11, s.not_covered)
        .run();
  Statement samples =
      database.prepare("INSERT INTO samples VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7, ?8, ?9)");
  Statement metrics = database.prepare("INSERT INTO metrics VALUES (?1, ?2, ?3, ?4, ?5, ?6)");
  for (const SampleRecord& s : r.samples) {
    samples.bind(1, number)
        .bind(2, s.modality)
        .bind(3, s.site)
        .bind(4, s.donning)
        .bind(5, s.score)
        .bind(6, s.margin)
        .bind(7, s.bound)
        .bind(8, s.limiting)
        .bind(9, s.reason)
        .run();
    for (const auto& [metric, value] : s.metrics)
      metrics.bind(1, number)
          .bind(2, s.modality)
          .bind(3, s.site)
          .bind(4, s.donning)
          .bind(5, metric)
          .bind(6, value)
          .run();
  }
  Statement notes = database.prepare("INSERT INTO notes VALUES (?1, ?2, ?3, ?4)");
  const auto note = [&](const std::string& kind, const std::vector<std::string>& texts) {
    for (std::size_t i = 0; i < texts.size(); ++i)
      notes.bind(1, number).bind(2, kind).bind(3, static_cast<int>(i + 1)).bind(4, texts[i]).run();
  };
  note("left out", r.left_out);
  note("warning", r.warnings);
  for (const auto& [modality, criteria] : r.untold) note("not told of " + modality, criteria);
  Statement versions = database.prepare("INSERT INTO versions VALUES (?1, ?2, ?3)");
  for (const auto& [library, version] : r.versions)
    versions.bind(1, number).bind(2, library).bind(3, version).run();
  database.prepare("INSERT INTO execution VALUES (?1, ?2, ?3, ?4)")
      .bind(1, number)
      .bind(2, r.execution.seconds)
      .bind(3, r.execution.peak_memory_mb)
      .bind(4, r.execution.host)
      .run();
}

void put_facts(const Database& database, const FolderPlan& plan) {
  const std::map<std::string, std::string> facts = {{"schema", std::to_string(kSchema)},
                                                    {"name", plan.name},
                                                    {"version", plan.version},
                                                    {"file_sha256", plan.file_sha256},
                                                    {"seed", std::to_string(plan.seed)},
                                                    {"design", plan.design},
                                                    {"looseness", plan.looseness},
                                                    {"sensors", std::to_string(plan.sensors)},
                                                    {"scorecards", join(scorecard_names(plan))},
                                                    {"spacing_m", shortest(plan.spacing)}};
  database.run("DELETE FROM study; DELETE FROM axes; DELETE FROM levels; DELETE FROM inputs");
  Statement fact = database.prepare("INSERT INTO study VALUES (?1, ?2)");
  for (const auto& [key, value] : facts) fact.bind(1, key).bind(2, value).run();
  Statement axis = database.prepare("INSERT INTO axes VALUES (?1, ?2, ?3, ?4)");
  for (std::size_t k = 0; k < plan.axes.size(); ++k)
    axis.bind(1, plan.axes[k].name)
        .bind(2, static_cast<int>(k + 1))
        .bind(3, plan.axes[k].kind)
        .bind(4, static_cast<int>(plan.axes[k].sampled))
        .run();
}

/// All rows in the order of their keys, which are the first columns.
std::string sorted_rows(const Database& database, const std::string& table) {
  constexpr int kLongestKey = 5;
  const int columns = database.prepare("SELECT * FROM " + table).columns();
  std::vector<std::string> order;
  for (int c = 1; c <= std::min(columns, kLongestKey); ++c) order.push_back(std::to_string(c));
  return "SELECT * FROM " + table + " ORDER BY " + join(order);
}

std::string rows_text(const Database& database, const std::string& table) {
  Statement rows = database.prepare(sorted_rows(database, table));
  std::string text;
  while (rows.step())
    for (int c = 0; c < rows.columns(); ++c)
      text += (rows.is_null(c)   ? "N"
               : rows.is_text(c) ? "T" + rows.text(c)
                                 : "R" + shortest(rows.number(c))) +
              '\x1f';
  return text;
}

}  // namespace

const std::vector<std::string>& table_names() {
  static const std::vector<std::string> kNames = {
      "study", "axes",  "cases",   "levels",  "inputs", "body",     "fit",      "garment",
      "maps",  "sites", "samples", "metrics", "notes",  "versions", "execution"};
  return kNames;
}

Store::Store(const fs::path& file) : database_(file, Database::Mode::write) {
  Transaction whole(database_);
  database_.run(kTables);
  whole.commit();
}

void Store::put_plan(const FolderPlan& plan) {
  Transaction whole(database_);
  put_facts(database_, plan);
  // Cases that stay what they were keep their results.
  std::map<int, std::string> known;
  for (Statement rows = database_.prepare("SELECT number, address FROM cases"); rows.step();)
    known[rows.integer(0)] = rows.text(1);
  std::set<int> planned;
  Statement level = database_.prepare("INSERT INTO levels VALUES (?1, ?2, ?3, ?4, ?5)");
  Statement input = database_.prepare("INSERT INTO inputs VALUES (?1, ?2, ?3)");
  for (const FolderCase& one : plan.cases) {
    planned.insert(one.number);
    const auto before = known.find(one.number);
    if (before == known.end() || before->second != one.address) {
      forget_results(database_, one.number);
      database_
          .prepare(
              "INSERT OR REPLACE INTO cases (number, address, status, drapes, edge_length_m) "
              "VALUES (?1, ?2, ?3, ?4, ?5)")
          .bind(1, one.number)
          .bind(2, one.address)
          .bind(3, std::string(kOpen))
          .bind(4, one.drapes)
          .bind(5, one.edge_length)
          .run();
    }
    for (std::size_t k = 0; k < plan.axes.size(); ++k) {
      const AxisLevel& at = plan.axes[k].levels[one.levels[k]];
      level.bind(1, one.number)
          .bind(2, plan.axes[k].name)
          .bind(3, one.levels[k] + 1)
          .bind(4, at.label)
          .bind(5, at.value.value_or(kNotKnown))
          .run();
      for (const auto& [name, value] : at.inputs)
        input.bind(1, one.number).bind(2, name).bind(3, value).run();
    }
  }
  for (const auto& [number, address] : known)
    if (!planned.count(number)) {
      forget_results(database_, number);
      database_.prepare("DELETE FROM cases WHERE number = ?1").bind(1, number).run();
    }
  whole.commit();
}

void Store::put(const FolderPlan& plan, const CaseRecord& record) {
  Transaction whole(database_);
  for (const FolderCase& one : plan.cases)
    if (one.address == record.address) put_record(database_, one.number, record);
  whole.commit();
}

void Store::forget(const std::string& address) {
  Transaction whole(database_);
  std::vector<int> numbers;
  {
    Statement rows = database_.prepare("SELECT number FROM cases WHERE address = ?1");
    for (rows.bind(1, address); rows.step();) numbers.push_back(rows.integer(0));
  }
  for (const int number : numbers) {
    forget_results(database_, number);
    database_
        .prepare(
            "UPDATE cases SET status = ?2, reason = NULL, residual = NULL, "
            "vertices = NULL, triangles = NULL, drapes_counted = NULL WHERE number = ?1")
        .bind(1, number)
        .bind(2, std::string(kOpen))
        .run();
  }
  whole.commit();
}

std::vector<std::string> Store::addresses() const {
  std::vector<std::string> found;
  Statement rows = database_.prepare(
      "SELECT DISTINCT address FROM cases WHERE status <> ?1 "
      "ORDER BY address");
  for (rows.bind(1, std::string(kOpen)); rows.step();) found.push_back(rows.text(0));
  return found;
}

void bring_up(Store& store, const StudyFolder& folder, const FolderPlan& plan) {
  store.put_plan(plan);
  const std::vector<std::string> listed = store.addresses();
  std::set<std::string> in(listed.begin(), listed.end()), seen;
  for (const FolderCase& one : plan.cases) {
    if (!seen.insert(one.address).second) continue;
    const std::optional<CaseRecord> record = folder.record(one.address);
    if (record && !in.count(one.address)) store.put(plan, *record);
    if (!record && in.count(one.address)) store.forget(one.address);
  }
}

void collect(const StudyFolder& folder, const FolderPlan& plan) {
  try {
    Store store(folder.database());
    return bring_up(store, folder, plan);
  } catch (const DamagedDatabase&) {
  }
  // Damaged, of another schema, or somebody else's: what the study needs is made anew.
  set_aside(folder.database(), "damaged", {"-journal"});
  Store store(folder.database());
  bring_up(store, folder, plan);
}

std::string content_sha256(const fs::path& file) {
  return content_sha256(Database(file, Database::Mode::read));
}

std::string content_sha256(const Database& database) {
  std::string digests;
  for (const std::string& table : table_names())
    if (table != "execution")
      digests += table + " " + sha256_hex(rows_text(database, table)) + "\n";
  return sha256_hex(digests);
}

std::vector<std::string> export_csv(const fs::path& file, const fs::path& folder) {
  return export_csv(Database(file, Database::Mode::read), folder);
}

std::vector<std::string> export_csv(const Database& database, const fs::path& folder) {
  io::RunFolder files = io::RunFolder::add(folder, "study-tables");
  std::vector<std::string> names;
  for (const std::string& table : table_names()) names.push_back(table + ".csv");
  files.announce(names);
  for (const std::string& table : table_names()) {
    Statement rows = database.prepare(sorted_rows(database, table));
    std::vector<std::string> fields;
    for (int c = 0; c < rows.columns(); ++c) fields.push_back(io::csv_field(rows.column_name(c)));
    std::string text = io::csv_line(fields);
    while (rows.step()) {
      fields.clear();
      for (int c = 0; c < rows.columns(); ++c)
        fields.push_back(rows.is_null(c)   ? ""
                         : rows.is_text(c) ? io::csv_field(rows.text(c))
                                           : io::csv_field(rows.number(c)));
      text += io::csv_line(fields);
    }
    io::write_text_file((files.path() / (table + ".csv")).string(), text);
  }
  files.commit();
  return names;
}

}  // namespace loosefit::study
