#include "command_study.h"

#include <fmt/format.h>

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "cache_flag.h"
#include "exit_code.h"
#include "interrupted.h"
#include "loosefit/base/error.h"
#include "loosefit/base/resources.h"
#include "loosefit/base/text.h"
#include "loosefit/io/run_folder.h"
#include "loosefit/study/analysis.h"
#include "loosefit/study/analysis_json.h"
#include "loosefit/study/compare.h"
#include "loosefit/study/comparison_files.h"
#include "loosefit/study/gallery.h"
#include "loosefit/study/report_files.h"
#include "loosefit/study/run_on_slurm.h"
#include "loosefit/study/run_study.h"
#include "loosefit/study/store.h"
#include "loosefit/study/study_page.h"
#include "loosefit/study/unit_words.h"
#include "loosefit/study/untold_modalities.h"
#include "loosefit/study/work_case.h"
#include "loosefit/study/worker_process.h"
#include "print_document.h"
#include "standard_error.h"
#include "terminal_progress.h"

namespace loosefit {
namespace {

using Json = nlohmann::json;

struct Arguments {
  std::string study, folder, other, output, executor = "local", address;
  bool quiet = false, json = false, retry_failed = false, overwrite = false;
  int index = 0;
  study::RunnerOptions runner;
};

/// Paths and reasons may be no UTF-8.
void print_json(const Json& json) {
  print_document(json.dump(1, ' ', false, Json::error_handler_t::replace));
}

CLI::Option* folder_option(CLI::App* command, const std::shared_ptr<Arguments>& arguments) {
  return command->add_option("DIR", arguments->folder, "folder of the study")->required();
}

/// What was hardly meant so.
void warn_of_plan(const study::Plan& plan) {
  for (const study::UntoldModality& untold : study::untold_modalities(plan))
    to_standard_error(fmt::format("warning: {}\n", terminal_line(study::untold_text(untold))));
  for (const std::string& axis : study::idle_axes(plan))
    to_standard_error(
        fmt::format("warning: axis {} changes nothing: cases that differ in it alone are the same "
                    "scenario\n",
                    terminal_line(axis)));
  for (const std::string& people : study::left_to_base(plan))
    to_standard_error(fmt::format("warning: {}\n", terminal_line(people)));
  for (const std::string& note : plan.notes)
    to_standard_error(fmt::format("note: {}\n", terminal_line(note)));
  if (const int same = study::same_as_others(plan); same > 0)
    to_standard_error(
        fmt::format("warning: {} of {} cases are the same scenario as another one; it runs once\n",
                    same, plan.cases.size()));
}

void tell_aside(const std::filesystem::path& file) {
  to_standard_error(
      fmt::format("note: not known to be as this program wrote it, so it is kept as {}\n",
                  terminal_line(file.string())));
}

/// `open`: addresses that are still to run.
void print_plan(const study::Plan& plan, const Arguments& arguments,
                const std::set<std::string>& open) {
  double work = 0;
  for (const auto& [address, seconds] : study::estimated_work(plan))
    if (open.contains(address)) work += seconds;
  const std::size_t to_run = static_cast<std::size_t>(std::ranges::count_if(
      plan.cases, [&](const study::PlannedCase& one) { return open.contains(one.address); }));
  const int workers = arguments.runner.jobs > 0 ? arguments.runner.jobs : usable_threads();
  if (arguments.json) {
    Json axes = Json::array();
    for (const study::Axis& axis : plan.study.axes)
      axes.push_back({{"name", axis.name}, {"kind", axis.kind}, {"levels", axis.levels.size()}});
    print_json({{"study", plan.study.name},
                {"cases", plan.cases.size()},
                {"drapes", plan.drapes()},
                {"axes", axes},
                {"estimated_core_seconds", work},
                {"estimated_seconds", work / workers},
                {"workers", workers},
                {"open", to_run},
                {"same_as_others", study::same_as_others(plan)},
                {"idle_axes", study::idle_axes(plan)},
                {"left_to_base", study::left_to_base(plan)}});
    return;
  }
  fmt::print("study    {}\ndesign   {}\n", terminal_line(plan.study.name),
             study::name(plan.study.design));
  for (const study::Axis& axis : plan.study.axes) {
    std::vector<std::string> labels;
    for (const study::AxisLevel& level : axis.levels) {
      if (labels.size() == 6) {
        labels.push_back("…");
        break;
      }
      labels.push_back(level.label);
    }
    fmt::print("axis     {}: {} {}{}: {}\n", terminal_line(axis.name), axis.levels.size(),
               axis.is_people() ? "people" : "levels", axis.sampled ? ", drawn" : "",
               terminal_line(join(labels)));
  }
  fmt::print("sensors  {}\ncases    {} ({} drapes){}\n",
             (plan.study.modalities.empty() ? "none: nothing is scored"
                                            : terminal_line(join(plan.study.modalities))),
             plan.cases.size(), plan.drapes(),
             to_run < plan.cases.size() ? fmt::format(", {} of them still to run", to_run) : "");
  fmt::print("time     about {} on {} workers of this machine, {} of one core\n",
             study::duration_text(work / workers), workers, study::duration_text(work));
}

void make_plan_command(CLI::App* parent, const std::shared_ptr<Arguments>& arguments) {
  CLI::App* command =
      parent->add_subcommand("plan", "cases and estimated time of a study, before anything runs");
  command->add_option("STUDY", arguments->study, "study file (docs/studies.md)")->required();
  command->add_option("-o,--output", arguments->output,
                      "also write plan and scenarios into this folder");
  command->add_option("-j,--jobs", arguments->runner.jobs, "workers to reckon with")
      ->check(CLI::Range(0, 1024));
  add_json_flag(*command, arguments->json);
  command->callback([arguments] {
    const study::Plan plan = study::make_plan(study::read_study_file(arguments->study));
    std::set<std::string> open;
    for (const study::PlannedCase& one : plan.cases) open.insert(one.address);
    if (!arguments->output.empty()) {
      const study::StudyFolder folder(arguments->output);
      const study::StudyLock lock(folder);
      folder.write_plan(plan, tell_aside);
      const std::vector<std::string> left = folder.state(folder.read_plan()).open;
      open = {left.begin(), left.end()};
    }
    print_plan(plan, *arguments, open);
    warn_of_plan(plan);
  });
}

/// \throws IoError for a folder that may only be read.
void need_leave_to_write(const study::StudyFolder& folder) {
  if (const auto part = folder.read_only_part())
    throw IoError(part->string() + ": may only be read by this user",
                  "-o OUT writes into another folder");
}

/// Whether an output goes elsewhere than into the folder of the study.
bool goes_elsewhere(const Arguments& arguments) {
  std::error_code error;
  return !arguments.output.empty() &&
         !std::filesystem::equivalent(arguments.output, arguments.folder, error);
}

/// The page, from the results. \pre nobody else writes into `to`
study::StudyAnalysis write_report(const study::StudyFolder& folder, const std::filesystem::path& to,
                                  Progress& progress, const study::SetAside& tell) {
  study::StudyAnalysis analysis = study::analyse(study::read_study_data(folder));
  const study::Gallery gallery = study::make_gallery(folder, analysis.data.plan, progress);
  study::write_report_files(to, study::study_html(analysis, gallery),
                            study::analysis_json(analysis), tell);
  return analysis;
}

/// Database and page in another folder, all or none; that of the study is only read.
study::StudyAnalysis report_elsewhere(const study::StudyFolder& folder, const std::string& to) {
  const study::FolderPlan plan = folder.read_plan();
  io::RunFolder files = io::RunFolder::add(to, "study-report");
  const std::string database = folder.database().filename().string();
  files.announce({"study-report.html", "study-report.json", database});
  {
    study::Store store(files.path() / database);
    study::bring_up(store, folder, plan);
  }
  Progress silent;
  study::StudyAnalysis analysis = write_report(folder, files.path(), silent, tell_aside);
  files.commit();
  return analysis;
}

/// Why cases have no scores: the reasons, the commonest first.
void tell_troubles(const study::StudyData& data) {
  std::map<std::string, int> counts;
  for (const study::CaseTrouble& t : data.troubles)
    if (t.status != "open" && t.status != "incomplete") ++counts[t.status + ": " + t.reason];
  std::vector<std::pair<std::string, int>> reasons(counts.begin(), counts.end());
  std::ranges::stable_sort(reasons, std::greater{}, &std::pair<std::string, int>::second);
  constexpr std::size_t kTold = 3;
  for (std::size_t i = 0; i < std::min(kTold, reasons.size()); ++i)
    fmt::print("{} × {}\n", reasons[i].second, terminal_line(reasons[i].first));
  if (reasons.size() > kTold) fmt::print("and others, on the page under Failures\n");
}

int run(const Arguments& arguments) {
  const study::Plan plan = study::make_plan(study::read_study_file(arguments.study));
  warn_of_plan(plan);
  const study::StudyFolder folder(arguments.output);
  study::RunnerOptions options = arguments.runner;
  options.program = study::own_program();
  TerminalProgress shown(arguments.quiet);
  InterruptGuard guard(shown);
  study::StudyRun done;
  study::StudyAnalysis analysis;
  std::vector<std::string> kept;
  try {
    const auto keep = [&](const std::filesystem::path& file) {
      shown.clear();
      tell_aside(file);
      kept.push_back(file.string());
    };
    done = study::run_study(
        plan, folder, options, arguments.executor == "slurm", arguments.retry_failed, shown,
        {keep, [&] { analysis = write_report(folder, folder.path(), shown, keep); }});
  } catch (const Cancelled&) {
    throw Interrupted("interrupted; finished cases stay",
                      "the same command goes on where it stopped");
  }
  shown.clear();
  const study::FolderState& state = done.state;
  if (arguments.json) {
    Json given_up = Json::array();
    for (const study::GivenUp& one : done.given_up)
      given_up.push_back({{"address", one.address}, {"why", one.why}});
    print_json({{"cases", plan.cases.size()},
                {"ran", done.ran},
                {"of_other_builds", done.of_other_builds},
                {"done", state.done},
                {"scored", analysis.data.scored},
                {"sealed", state.sealed},
                {"failed", state.failed},
                {"open", state.open_cases},
                {"given_up", given_up},
                {"set_aside", kept},
                {"seconds", done.seconds},
                {"headlines", study::headlines(analysis)},
                {"content_sha256", study::content_sha256(folder.database())}});
  } else if (!arguments.quiet) {
    fmt::print("{} of {} cases ran in {}; {} have scores, {} are sealed, {} failed\n", done.ran,
               plan.cases.size(), study::duration_text(done.seconds), analysis.data.scored,
               state.sealed, state.failed);
    for (const std::string& sentence : study::headlines(analysis))
      fmt::print("{}\n", terminal_line(sentence));
    tell_troubles(analysis.data);
    fmt::print("written: {}\n", terminal_line((folder.path() / "study-report.html").string()));
  }
  if (done.of_other_builds > 0)
    to_standard_error(fmt::format(
        "warning: the results of {} cases are of another build of the program, of the same "
        "version; a new folder has all of one\n",
        done.of_other_builds));
  for (const study::GivenUp& one : done.given_up)
    to_standard_error(fmt::format("warning: case {} stays open: {}\n", one.address.substr(0, 12),
                                  terminal_line(one.why)));
  // Nothing that could be judged is no success, though every case has ended.
  const int settled = analysis.data.modalities.empty() ? state.done : analysis.data.scored;
  const bool good = state.open.empty() && (settled > 0 || plan.cases.empty());
  return good ? kGood : kNotSettled;
}

void make_run_command(CLI::App* parent, const std::shared_ptr<Arguments>& arguments,
                      int& exit_code) {
  CLI::App* command = parent->add_subcommand(
      "run", "runs all cases that have no result yet, and writes database and page");
  command->add_option("STUDY", arguments->study, "study file (docs/studies.md)")->required();
  command->add_option("-o,--output", arguments->output, "folder of the study, new or earlier")
      ->required();
  command->add_option("-j,--jobs", arguments->runner.jobs, "cases at a time; 0: one per core")
      ->check(CLI::Range(0, 1024));
  command->add_option("--threads", arguments->runner.threads, "threads of each case")
      ->check(CLI::Range(1, 256));
  add_cache_flag(*command);
  command->add_flag("--keep-output", arguments->runner.keep_output,
                    "also keep all files of each case, as of loosefit run");
  command->add_flag("--retry-failed", arguments->retry_failed, "run failed cases again");
  command->add_option("--executor", arguments->executor, "local or slurm")
      ->check(CLI::IsMember({"local", "slurm"}));
  command->add_option("--partition", arguments->runner.partition, "of Slurm");
  command->add_option("--time", arguments->runner.time_limit,
                      "time limit of an array task, as sbatch takes it");
  command->add_option("--bundle", arguments->runner.bundle, "cases per array task")
      ->check(CLI::Range(1, 100000));
  command->add_option("--memory-mb", arguments->runner.memory_mb, "of an array task")
      ->check(CLI::Range(0, 10000000));
  command->add_flag("-q,--quiet", arguments->quiet, "no progress, no summary");
  add_json_flag(*command, arguments->json);
  command->callback([arguments, &exit_code] { exit_code = run(*arguments); });
}

void make_status_command(CLI::App* parent, const std::shared_ptr<Arguments>& arguments) {
  CLI::App* command = parent->add_subcommand("status", "what of a study is done");
  folder_option(command, arguments);
  add_json_flag(*command, arguments->json);
  command->callback([arguments] {
    const study::StudyFolder folder(arguments->folder);
    const study::FolderPlan plan = folder.read_plan();
    const study::FolderState state = folder.state(plan);
    if (arguments->json)
      return print_json({{"cases", plan.cases.size()},
                         {"done", state.done},
                         {"scored", state.scored},
                         {"sealed", state.sealed},
                         {"failed", state.failed},
                         {"open", state.open_cases}});
    fmt::print("{}: {}, {} have scores, {} sealed, {} failed, {} to run\n",
               terminal_line(plan.name),
               study::counted(static_cast<int>(plan.cases.size()), "case", "cases"), state.scored,
               state.sealed, state.failed, state.open_cases);
  });
}

void make_report_command(CLI::App* parent, const std::shared_ptr<Arguments>& arguments) {
  CLI::App* command =
      parent->add_subcommand("report", "database and page anew from the results that are there");
  folder_option(command, arguments);
  command->add_option("-o,--output", arguments->output,
                      "folder for database and page; DIR is then only read");
  add_json_flag(*command, arguments->json);
  command->callback([arguments] {
    const study::StudyFolder folder(arguments->folder);
    const bool elsewhere = goes_elsewhere(*arguments);
    const std::filesystem::path to = elsewhere ? arguments->output : arguments->folder;
    const study::StudyAnalysis analysis = [&] {
      if (elsewhere) return report_elsewhere(folder, arguments->output);
      folder.read_plan();  // what is no study stays as it is, without a lock
      need_leave_to_write(folder);
      const study::StudyLock lock(folder);
      study::collect(folder, folder.read_plan());
      Progress silent;
      return write_report(folder, to, silent, tell_aside);
    }();
    if (arguments->json) return print_document(study::analysis_json(analysis));
    for (const std::string& sentence : study::headlines(analysis))
      fmt::print("{}\n", terminal_line(sentence));
    fmt::print("written: {}\n", terminal_line((to / "study-report.html").string()));
  });
}

void make_export_command(CLI::App* parent, const std::shared_ptr<Arguments>& arguments) {
  CLI::App* command = parent->add_subcommand("export", "every table of the database as CSV");
  folder_option(command, arguments);
  command->add_option("-o,--output", arguments->output, "folder; usually DIR/csv");
  command->add_flag("-q,--quiet", arguments->quiet, "no words on what was written");
  add_json_flag(*command, arguments->json);
  command->callback([arguments] {
    const study::StudyFolder folder(arguments->folder);
    const std::string to =
        arguments->output.empty() ? (folder.path() / "csv").string() : arguments->output;
    const study::FolderPlan plan = folder.read_plan();
    std::optional<study::Store> own;
    if (goes_elsewhere(*arguments) && folder.read_only_part()) {
      study::bring_up(own.emplace(""), folder, plan);
    } else {
      need_leave_to_write(folder);
      const study::StudyLock lock(folder);
      study::collect(folder, folder.read_plan());
    }
    std::optional<study::Database> there;
    if (!own) there.emplace(folder.database(), study::Database::Mode::read);
    const study::Database& database = own ? own->database() : *there;
    const std::vector<std::string> files = study::export_csv(database, to);
    const std::string content = study::content_sha256(database);
    if (arguments->json)
      return print_json({{"folder", to}, {"files", files}, {"content_sha256", content}});
    if (arguments->quiet) return;
    fmt::print("written: {} ({} tables)\ncontent: {}\n", terminal_line(to), files.size(), content);
  });
}

void make_compare_command(CLI::App* parent, const std::shared_ptr<Arguments>& arguments) {
  CLI::App* command =
      parent->add_subcommand("compare", "paired differences of two studies of the same people");
  command->add_option("A", arguments->folder, "folder of a study")->required();
  command->add_option("B", arguments->other, "folder of another")->required();
  command->add_option("-o,--output", arguments->output,
                      "CSV file to write; limits of looseness go to NAME.limits.csv beside it");
  command->add_flag("--overwrite", arguments->overwrite, "replace a file that is there already");
  add_json_flag(*command, arguments->json);
  command->callback([arguments] {
    const bool kept = !arguments->output.empty();
    if (kept) study::check_comparison_files(arguments->output, arguments->overwrite);
    const study::StudyComparison comparison =
        study::compare_studies(study::read_study_data(study::StudyFolder(arguments->folder)),
                               study::read_study_data(study::StudyFolder(arguments->other)));
    if (kept) study::write_comparison(comparison, arguments->output, arguments->overwrite);
    if (arguments->json) return print_document(study::comparison_json(comparison));
    fmt::print("{}", terminal_text(study::comparison_text(comparison)));
  });
}

/// What a runner starts: one case in this process, or the cases of an array task.
void make_worker_commands(CLI::App* parent, const std::shared_ptr<Arguments>& arguments,
                          int& exit_code) {
  const auto common = [arguments](CLI::App* command) {
    command->group("");  // not for people
    command->add_option("--threads", arguments->runner.threads)->check(CLI::Range(1, 256));
    command->add_flag("--keep-output", arguments->runner.keep_output);
  };
  CLI::App* work = parent->add_subcommand("work", "runs one case of a study");
  folder_option(work, arguments);
  work->add_option("ADDRESS", arguments->address)->required();
  common(work);
  work->callback([arguments] {
    const study::StudyFolder folder(arguments->folder);
    const study::FolderPlan plan = folder.read_plan();
    Progress silent;
    study::work_case(folder, plan, arguments->address,
                     {arguments->runner.threads, arguments->runner.keep_output}, silent);
  });
  CLI::App* bundle = parent->add_subcommand("bundle", "runs the cases of one array task");
  folder_option(bundle, arguments);
  bundle->add_option("BUNDLES", arguments->study)->required();
  bundle->add_option("INDEX", arguments->index)->required();
  common(bundle);
  bundle->callback([arguments, &exit_code] {
    const study::StudyFolder folder(arguments->folder);
    study::RunnerOptions options = arguments->runner;
    options.program = study::own_program();
    options.jobs = 1;
    std::vector<std::string> open;
    for (const std::string& address : study::read_bundle(arguments->study, arguments->index))
      if (!folder.record(address)) open.push_back(address);
    Progress silent;
    const auto given_up = study::run_here(
        folder, open, options, [](const study::CaseRecord&) {}, silent);
    for (const study::GivenUp& one : given_up)
      to_standard_error(fmt::format("{}: {}\n", one.address, terminal_line(one.why)));
    exit_code = given_up.empty() ? kGood : kNotSettled;
  });
}

}  // namespace

void add_study_command(CLI::App& app, int& exit_code) {
  CLI::App* parent = app.add_subcommand("study", "many cases: people, fits, fabrics, wearing");
  parent->require_subcommand(1);
  const auto arguments = std::make_shared<Arguments>();
  make_plan_command(parent, arguments);
  make_run_command(parent, arguments, exit_code);
  make_status_command(parent, arguments);
  make_report_command(parent, arguments);
  make_export_command(parent, arguments);
  make_compare_command(parent, arguments);
  make_worker_commands(parent, arguments, exit_code);
}

}  // namespace loosefit
