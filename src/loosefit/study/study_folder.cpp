#include "loosefit/study/study_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <nlohmann/json.hpp>
#include <set>

#include "loosefit/base/control_characters.h"
#include "loosefit/base/error.h"
#include "loosefit/base/sha256.h"
#include "loosefit/base/text.h"
#include "loosefit/base/version.h"
#include "loosefit/io/output_name.h"
#include "loosefit/io/scenario.h"
#include "loosefit/io/text_file.h"
#include "loosefit/study/plan.h"

namespace loosefit::study {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::json;

constexpr const char* kFormat = "loosefit-study 1";
constexpr std::size_t kLargestPlan = 2000000000, kLargestScenario = 1000000;
const char* const kWriting = ".writing-";  ///< in the name of a file that is not yet whole

IoError failed(const fs::path& path, const char* what) {
  return IoError(path.string() + ": " + what + ": " + std::strerror(errno));
}

void make_folders(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw IoError(folder.string() + ": cannot be made: " + error.message());
}

Json axis_json(const Axis& axis) {
  Json levels = Json::array();
  for (const AxisLevel& level : axis.levels)
    levels.push_back({{"label", level.label},
                      {"value", level.value ? Json(*level.value) : Json(nullptr)},
                      {"inputs", level.inputs}});
  return {{"name", axis.name},           {"kind", axis.kind},
          {"sampled", axis.sampled},     {"stratified", axis.stratified},
          {"each_case", axis.each_case}, {"levels", levels}};
}

Axis axis_of(const Json& json) {
  Axis axis;
  axis.name = json.at("name");
  axis.kind = json.at("kind");
  axis.sampled = json.at("sampled");
  axis.stratified = json.value("stratified", false);  // unknown to plans of earlier programs
  axis.each_case = json.at("each_case");
  for (const Json& j : json.at("levels")) {
    AxisLevel& level = axis.levels.emplace_back();
    level.label = j.at("label");
    if (!j.at("value").is_null()) level.value = j.at("value").get<double>();
    level.inputs = j.at("inputs").get<std::map<std::string, double>>();
  }
  return axis;
}

std::optional<double> optional_number(const Json& json, const char* key) {
  const auto found = json.find(key);
  if (found == json.end() || found->is_null()) return {};
  return found->get<double>();
}

Json plan_json(const Plan& plan) {
  const StudyFile& study = plan.study;
  Json json = {{"format", kFormat},
               {"name", study.name},
               {"version", version()},
               {"file_sha256", sha256_hex(study.text)},
               {"seed", study.seed},
               {"design", name(study.design)},
               {"scorecards", study.modalities},
               {"scorecard_texts", plan.cards},
               {"looseness", study.looseness},
               {"sensors", study.sensors},
               {"spacing", study.spacing},
               {"not_at", study.not_at},
               {"axes", Json::array()},
               {"cases", Json::array()}};
  for (const Axis& axis : study.axes) json["axes"].push_back(axis_json(axis));
  for (const PlannedCase& one : plan.cases)
    json["cases"].push_back({{"number", one.number},
                             {"levels", one.levels},
                             {"address", one.address},
                             {"drapes", one.drapes},
                             {"edge_length", one.edge_length},
                             {"looseness", one.looseness ? Json(*one.looseness) : Json(nullptr)},
                             {"wearer", one.wearer},
                             {"wearing", one.wearing}});
  return json;
}

/// Addresses become paths and levels indices: what the program does not write is refused.
void check_plan(const FolderPlan& plan, const std::string& file) {
  const auto refuse = [&](const std::string& key, const std::string& found,
                          const std::string& expected) {
    throw InvalidInput({file, 0, key}, found, expected);
  };
  for (std::size_t i = 0; i < plan.cases.size(); ++i) {
    const FolderCase& one = plan.cases[i];
    const std::string of_case = " of case " + std::to_string(one.number);
    if (one.number != static_cast<int>(i) + 1)
      refuse("cases.number", std::to_string(one.number), std::to_string(i + 1));
    constexpr std::size_t kDigits = 64;
    if (one.address.size() != kDigits ||
        one.address.find_first_not_of("0123456789abcdef") != std::string::npos)
      refuse("cases.address", "\"" + printable(one.address) + "\"" + of_case,
             "64 hexadecimal digits");
    if (one.levels.size() != plan.axes.size())
      refuse("cases.levels", std::to_string(one.levels.size()) + of_case,
             "one for each of " + std::to_string(plan.axes.size()) + " axes");
    for (std::size_t k = 0; k < plan.axes.size(); ++k)
      if (one.levels[k] < 0 || one.levels[k] >= static_cast<int>(plan.axes[k].levels.size()))
        refuse("cases.levels", std::to_string(one.levels[k]) + of_case,
               "a level of the axis " + printable(plan.axes[k].name));
  }
  if (!plan.cards.empty() && plan.cards.size() != plan.modalities.size())
    refuse("scorecard_texts", std::to_string(plan.cards.size()),
           "one for each of " + std::to_string(plan.modalities.size()) + " scorecards");
  if (const int loose = looseness_axis(plan); loose >= 0)
    for (const AxisLevel& level : plan.axes[loose].levels)
      if (!level.value)
        refuse("looseness", "\"" + printable(plan.looseness) + "\"",
               "an axis whose levels have a value");
}

}  // namespace

void write_whole(const fs::path& named, const std::string& text) {
  const fs::path file = fs::absolute(named);
  const fs::path temporary =
      file.parent_path() / ("." + file.filename().string() + kWriting + std::to_string(getpid()));
  try {
    io::write_text_file(temporary.string(), text);
    io::sync_to_disk(temporary);
    io::move_over(temporary, file);
  } catch (...) {
    std::error_code error;
    fs::remove(temporary, error);
    throw;
  }
  io::sync_to_disk(file.parent_path());
}

void remove_left_overs(const fs::path& file) {
  const std::string begin = "." + file.filename().string() + kWriting;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(file.parent_path(), error))
    if (entry.path().filename().string().starts_with(begin)) fs::remove(entry.path(), error);
}

StudyFolder::StudyFolder(fs::path path) : path_(std::move(path)) { io::check_output_name(path_); }

fs::path StudyFolder::case_folder(const std::string& address) const {
  return path_ / "cases" / address.substr(0, 2) / address;
}

fs::path StudyFolder::scenario_file(const std::string& address) const {
  return case_folder(address) / "scenario.toml";
}

fs::path StudyFolder::result_file(const std::string& address) const {
  return case_folder(address) / "result.json";
}

namespace {

/// A file that only a runner writes, which has the lock: what a killed one has left goes first.
/// Whether a file is a scenario of the case with this address: one that changes no result may
/// differ from the planned one, in the views of pictures for example.
bool is_scenario_of(const fs::path& file, const std::string& address,
                    const std::vector<std::string>& modalities) {
  try {
    return case_address(io::read_scenario(file.string()), modalities) == address;
  } catch (const Error&) {
    return false;
  }
}

void write_planned(const fs::path& file, const std::string& text) {
  remove_left_overs(file);
  write_whole(file, text);
}

}  // namespace

std::optional<fs::path> StudyFolder::read_only_part() const {
  const auto allowed = [](const fs::path& path, int how) {
    return faccessat(AT_FDCWD, path.c_str(), how, AT_EACCESS) == 0;
  };
  if (!allowed(path_, W_OK | X_OK)) return path_;
  for (const fs::path& file : {database(), path_ / ".lock"})
    if (io::is_there(file) && !allowed(file, R_OK | W_OK)) return file;
  return {};
}

void StudyFolder::check_ours() const {
  if (!io::is_there(path_)) return;
  std::error_code error;
  // A study whose plan is gone or damaged gets it back from its study file.
  const bool is_study =
      fs::is_directory(path_ / "cases", error) && io::is_there(path_ / "study.toml");
  const fs::path file = path_ / "plan.json";
  if (io::is_there(file)) {
    const Json json = Json::parse(io::read_text_file(file.string(), kLargestPlan), nullptr, false);
    if (json.is_discarded() ? is_study
                            : json.is_object() && json.value("format", Json()) == kFormat)
      return;
    throw InvalidInput({file.string(), 0, "format"}, "a file that is no plan of a study", kFormat,
                       "choose another folder, or move this file away");
  }
  if (is_study) return;
  for (const auto& entry : fs::directory_iterator(path_, error))
    if (const std::string name = entry.path().filename().string(); name[0] != '.')
      throw InvalidInput({path_.string(), 0, ""},
                         "a folder that is no study, with " + printable(name) + " in it",
                         "a new or empty folder, or that of an earlier study");
  if (error) throw IoError(path_.string() + ": cannot be read: " + error.message());
}

std::optional<FolderPlan> StudyFolder::plan_before() const {
  try {
    return read_plan();
  } catch (const InvalidInput&) {
    return {};  // none, or one that is written anew
  }
}

void StudyFolder::check_same_study(const Plan& plan,
                                   const std::optional<FolderPlan>& before) const {
  const fs::path own = path_ / "study.toml";
  if (!before) {
    if (io::is_there(own) && io::plain_digest(path_, "study.toml") != sha256_hex(plan.study.text))
      throw InvalidInput({own.string(), 0, ""},
                         "another study file beside no plan.json, or a damaged one",
                         "the study file that is asked for, or a new folder");
    return;
  }
  if (before->name == plan.study.name) return;
  std::set<std::string> known;
  for (const FolderCase& one : before->cases) known.insert(one.address);
  for (const PlannedCase& one : plan.cases)
    if (known.count(one.address)) return;
  throw InvalidInput(
      {path_.string(), 0, ""}, "the study \"" + printable(before->name) + "\"",
      "a folder of its own for \"" + printable(plan.study.name) + "\", which has no case of it",
      "name = \"" + printable(before->name) + "\" in [study] if it is the same one, changed");
}

void StudyFolder::write_plan(const Plan& plan, const SetAside& tell) const {
  check_ours();
  const std::optional<FolderPlan> before = plan_before();
  check_same_study(plan, before);
  const fs::path plan_file = path_ / "plan.json", study_file = path_ / "study.toml";
  const std::string plan_text =
      json_without_controls(plan_json(plan).dump(1)) + "\n";  // may throw: nothing is written yet
  if (!before && io::is_there(plan_file)) tell(set_aside(plan_file, "damaged"));
  if (before && io::is_there(study_file))
    if (const auto there = io::plain_digest(path_, "study.toml");
        there != before->file_sha256 && there != sha256_hex(plan.study.text))
      tell(set_aside(study_file, "changed"));
  // The plan first where there is none: it marks the folder as a study, also when the rest is cut
  // off.
  make_folders(path_);
  if (before) write_planned(study_file, plan.study.text);  // else the old one looks changed
  write_planned(plan_file, plan_text);
  if (!before) write_planned(study_file, plan.study.text);
  std::set<std::string> written;
  for (const PlannedCase& one : plan.cases) {
    if (!written.insert(one.address).second) continue;
    const fs::path file = scenario_file(one.address);
    if (io::is_there(file)) {
      if (io::read_text_file(file.string(), kLargestScenario) == one.toml) continue;
      if (!is_scenario_of(file, one.address, plan.study.modalities))
        tell(set_aside(file, "changed"));
    }
    make_folders(file.parent_path());
    write_planned(file, one.toml);
  }
}

FolderPlan StudyFolder::read_plan() const {
  const fs::path file = path_ / "plan.json";
  std::error_code error;
  const fs::file_status there = fs::status(file, error);
  if (there.type() == fs::file_type::none)
    throw IoError(file.string() + ": cannot be read: " + error.message());
  if (!fs::exists(there))
    throw InvalidInput({path_.string(), 0, ""}, "no plan.json", "the folder of a study",
                       "loosefit study run STUDY.toml -o DIR makes one");
  try {
    const Json json = Json::parse(io::read_text_file(file.string(), kLargestPlan));
    if (json.at("format") != kFormat)
      throw InvalidInput({file.string(), 0, "format"}, json.at("format").dump(), kFormat);
    FolderPlan plan;
    plan.name = json.at("name");
    plan.version = json.at("version");
    plan.file_sha256 = json.at("file_sha256");
    plan.seed = json.at("seed");
    plan.design = json.at("design");
    plan.modalities = json.at("scorecards").get<std::vector<std::string>>();
    plan.cards = json.value("scorecard_texts", std::vector<std::string>());
    plan.looseness = json.at("looseness");
    plan.sensors = json.at("sensors");
    plan.spacing = json.at("spacing");
    plan.not_at = json.at("not_at").get<std::vector<std::string>>();
    for (const Json& axis : json.at("axes")) plan.axes.push_back(axis_of(axis));
    for (const Json& j : json.at("cases"))
      plan.cases.push_back({j.at("number"), j.at("levels").get<std::vector<int>>(), j.at("address"),
                            j.at("drapes"), j.at("edge_length"), optional_number(j, "looseness"),
                            j.value("wearer", std::string()), j.value("wearing", std::string())});
    check_plan(plan, file.string());
    return plan;
  } catch (const Json::exception& e) {
    std::string what = e.what();
    if (const std::size_t at = what.find("] "); at != std::string::npos) what.erase(0, at + 2);
    throw InvalidInput({file.string(), 0, ""}, "no whole plan (" + printable(what) + ")",
                       "plan.json as the program wrote it",
                       "loosefit study plan STUDY.toml -o DIR writes it anew");
  }
}

std::optional<CaseRecord> StudyFolder::record(const std::string& address) const {
  return read_record(result_file(address), address);
}

FolderState StudyFolder::state(const FolderPlan& plan) const {
  struct Seen {
    std::optional<CaseStatus> status;
    bool scored = false;
  };
  FolderState state;
  std::map<std::string, Seen> all;
  for (const FolderCase& one : plan.cases) {
    auto [known, is_new] = all.try_emplace(one.address);
    Seen& seen = known->second;
    if (is_new) {
      if (const auto found = record(one.address))
        seen = {found->status, is_scored(*found)};
      else
        state.open.push_back(one.address);
    }
    state.open_cases += !seen.status;
    if (!seen.status) continue;
    state.done += *seen.status == CaseStatus::done;
    state.scored += seen.scored;
    state.sealed += *seen.status == CaseStatus::sealed;
    state.failed += *seen.status == CaseStatus::failed;
  }
  return state;
}

int StudyFolder::forget_failed(const FolderPlan& plan) const {
  int forgotten = 0;
  for (const FolderCase& one : plan.cases) {
    const std::optional<CaseRecord> found = record(one.address);
    if (!found || found->status != CaseStatus::failed) continue;
    const fs::path file = result_file(one.address);
    std::error_code error;
    if (!fs::remove(file, error)) throw IoError(file.string() + ": cannot be removed");
    ++forgotten;
  }
  return forgotten;
}

StudyLock::StudyLock(const StudyFolder& folder) {
  folder.check_ours();
  make_folders(folder.path());
  const fs::path file = folder.path() / ".lock";
  descriptor_ = open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
  if (descriptor_ < 0) throw failed(file, "cannot be opened");
  char host[256] = "?";
  gethostname(host, sizeof host - 1);
  if (flock(descriptor_, LOCK_EX | LOCK_NB) != 0) {
    const int cause = errno;
    char other[512] = "";
    const ssize_t n = pread(descriptor_, other, sizeof other - 1, 0);
    close(descriptor_);
    descriptor_ = -1;
    errno = cause;
    if (cause != EWOULDBLOCK) throw failed(file, "cannot be locked");
    const std::string who = n > 0 ? std::string(other, static_cast<std::size_t>(n)) : "another one";
    throw InvalidInput({folder.path().string(), 0, ""},
                       "a study that " + printable(who, 200) + " is just running",
                       "one runner at a time", "wait for it, or stop it; its finished cases stay");
  }
  constexpr std::string_view kProcess = "process ";
  char before[kProcess.size()];
  const ssize_t there = pread(descriptor_, before, sizeof before, 0);
  // A file of that name that somebody else has written stays as it is, and is the lock all the
  // same.
  if (there != 0 &&
      std::string_view(before, static_cast<std::size_t>(std::max<ssize_t>(there, 0))) != kProcess)
    return;
  const std::string text = std::string(kProcess) + std::to_string(getpid()) + " on " + host;
  if (ftruncate(descriptor_, 0) != 0 ||
      pwrite(descriptor_, text.data(), text.size(), 0) != static_cast<ssize_t>(text.size())) {
    // The name is for messages alone; the lock holds without it, on a full disk for example.
  }
}

StudyLock::~StudyLock() {
  if (descriptor_ >= 0) close(descriptor_);
}

}  // namespace loosefit::study
