#include "loosefit/study/wear_states.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <random>

#include "loosefit/body/named_postures.h"
#include "loosefit/drape/worn_limbs.h"
#include "loosefit/study/case_layers.h"
#include "loosefit/study/case_stages.h"

namespace loosefit {
namespace {

using Clock = std::chrono::steady_clock;
double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Hides the stages of a drape inside a larger one.
class Unstaged : public Progress {
 public:
  explicit Unstaged(Progress& shown) : shown_(shown) {}
  void update(double fraction, const std::string& note) override { shown_.update(fraction, note); }
  void check_cancelled() const override { shown_.check_cancelled(); }

 private:
  Progress& shown_;
};

BodyPath way(const CaseResult& result, int posture) {
  return [pose = result.body.pose, from = result.scenario.body.posture,
          to = named_posture(result.wear.postures[posture])](double share) {
    return pose(blend(from, to, share));
  };
}

CaseState state_of(const CaseWear& wear, int posture, int donning) {
  CaseState state;
  state.posture = posture, state.donning = donning;
  state.name = wear.postures[posture];
  return state;
}

}  // namespace

void check_worn(const CaseResult& result, CaseState& state) {
  if (!state.drape.certificate.settled()) return;
  const Body& body = *result.wear.bodies[state.posture];
  const auto as_before = [&](const Garment& garment, const Drape& now, const Drape& first) {
    return limbs_through_openings(garment.triangles, now.positions, body) ==
           limbs_through_openings(garment.triangles, first.positions, result.body.body);
  };
  bool worn = as_before(result.mesh(), state.drape, result.drape);
  for (std::size_t l = 0; l < result.under.size(); ++l)
    worn = worn && as_before(result.under[l].mesh(), state.under[l], result.under[l].drape);
  if (!worn)
    state.left_out =
        "an arm or the trunk has left the opening it went through, or gone through the cloth";
}

namespace {

void follow_all(CaseResult& result, DrapeSession& session, int donning) {
  for (int p = 1; p < static_cast<int>(result.wear.postures.size()); ++p) {
    CaseState state = state_of(result.wear, p, donning);
    const auto start = Clock::now();
    take_drape(session.follow(way(result, p)), result, state);
    state.seconds = seconds_since(start);
    check_worn(result, state);
    result.wear.states.push_back(std::move(state));
  }
}

void put_on_again(CaseResult& result, int donning, Progress& progress) {
  const CaseDonning& how = result.wear.donnings[donning];
  DrapeOptions options = drape_options(result.scenario.simulation);
  options.start_shift = how.shift;
  options.start_twist = how.twist;
  const auto start = Clock::now();
  DrapeSession session(cloth_layers(result, how.friction), options, progress);
  CaseState state = state_of(result.wear, 0, donning);
  take_drape(put_on(session, result.body), result, state);
  state.seconds = seconds_since(start);
  check_worn(result, state);
  const bool counts = state.counts();
  result.wear.states.push_back(std::move(state));
  if (counts) return follow_all(result, session, donning);
  for (int p = 1; p < static_cast<int>(result.wear.postures.size()); ++p) {
    result.wear.states.push_back(state_of(result.wear, p, donning));
    result.wear.states.back().left_out = "not tried: failed in the reference posture";
  }
}

}  // namespace

CaseWear plan_wear(const CaseResult& result) {
  const Scenario& scenario = result.scenario;
  CaseWear wear;
  if (scenario.postures.size() < 2 && scenario.donning.repeats < 2) return wear;
  wear.postures = scenario.postures;
  if (wear.postures.empty()) wear.postures = {"reference"};
  wear.bodies.push_back(std::make_shared<const Body>(result.body.body));
  for (std::size_t p = 1; p < wear.postures.size(); ++p)
    wear.bodies.push_back(
        std::make_shared<const Body>(result.body.pose(named_posture(wear.postures[p]))));
  std::mt19937_64 rng(scenario.donning.seed);
  std::uniform_real_distribution<double> even(-1, 1);
  std::normal_distribution<double> normal;
  wear.donnings.resize(1);
  for (int k = 1; k < scenario.donning.repeats; ++k) {
    CaseDonning& how = wear.donnings.emplace_back();
    for (double& s : how.shift) s = scenario.donning.shift * even(rng);
    how.twist = scenario.donning.twist * even(rng);
    how.friction = std::exp(scenario.donning.friction_spread * std::clamp(normal(rng), -2.0, 2.0));
  }
  return wear;
}

void wear_states(CaseResult& result, DrapeSession& first, Progress& progress) {
  const bool settled = result.drape.certificate.settled();
  if (settled && result.scenario.postures.size() > 1) progress.stage("body");
  result.wear = plan_wear(result);
  if (result.wear.postures.empty() || !settled) return;
  if (result.wear.postures.size() > 1) {
    progress.stage("postures");
    follow_all(result, first, 0);
  }
  if (result.wear.donnings.size() < 2) return;
  progress.stage("donnings");
  Unstaged inner(progress);
  for (int k = 1; k < static_cast<int>(result.wear.donnings.size()); ++k)
    put_on_again(result, k, inner);
}

std::vector<WornState> worn_states(const CaseResult& result) {
  std::vector<WornState> all = {
      {0, 0, result.drape.positions, result.body.body, result.maps.worn,
       result.maps.pressure.field.empty() ? nullptr : &result.maps.pressure.field}};
  for (const CaseState& s : result.wear.states)
    if (s.counts())
      all.push_back({s.posture, s.donning, s.drape.positions,
                     s.posture == 0 ? result.body.body : *result.wear.bodies[s.posture], s.worn,
                     s.pressure.empty() ? nullptr : &s.pressure});
  return all;
}

std::vector<std::string> wear_warnings(const CaseResult& result) {
  std::vector<std::string> all;
  const CaseWear& wear = result.wear;
  if (!wear.postures.empty() && wear.states.empty())
    all.push_back("postures: none taken and nothing put on again: the first drape is not settled");
  for (const CaseState& s : wear.states) {
    if (s.counts()) continue;
    const std::string where =
        wear.donnings.size() > 1 ? fmt::format("{} of donning {}", s.name, s.donning + 1) : s.name;
    const Certificate& c = s.drape.certificate;
    all.push_back(fmt::format("postures: {} is left out of all statistics: {}", where,
                              s.left_out.empty() ? fmt::format("not settled ({}), residual {:.2e}",
                                                               c.stop_reason, c.residual)
                                                 : s.left_out));
  }
  return all;
}

std::filesystem::path state_folder(const CaseState& state) {
  if (state.donning == 0) return std::filesystem::path("postures") / state.name;
  return std::filesystem::path("donnings") / std::to_string(state.donning + 1) / state.name;
}

}  // namespace loosefit
