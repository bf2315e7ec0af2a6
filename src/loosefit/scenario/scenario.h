#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "loosefit/body/body.h"
#include "loosefit/drape/drape_options.h"
#include "loosefit/garment/attachment.h"
#include "loosefit/pattern/named_cloth.h"
#include "loosefit/pattern/named_edges.h"
#include "loosefit/placement/sites.h"
#include "loosefit/scenario/material_card.h"

// Plain values: what a scenario asks for, with every default. Nothing here reads, writes or
// decides.
namespace loosefit::scenario {

/// [body]: a parametric person or a mesh file.
struct ScenarioBody {
  double sex = 0;                              ///< 0 female … 1 male
  double age = 30;                             ///< years
  double height = 1.68;                        ///< [m]
  std::map<std::string, double> measurements;  ///< wished tape measures [m]
  double muscle = 0.5, proportions = 0.5, cup = 0.5, firmness = 0.5;
  body::Posture posture = body::kStanding;         ///< in which the maps are made
  body::Posture dress_posture = body::kArmsApart;  ///< in which the garment is put on
  std::string file;        ///< mesh file instead of the parametric person; absolute
  bool as_scanned = true;  ///< the person of a file stands as in it, not in `posture`
  std::string units;       ///< of the file: m, cm, mm, in; empty = inferred with a warning
  std::string up;          ///< axis of the file: z, y; empty = inferred with a warning
};

/// What a garment is: a kind with its size or fit, or a pattern file.
struct GarmentSpec {
  std::string kind = "long-sleeve-shirt";  ///< GarmentKind::name (kinds/registry.h)
  std::string file;                        ///< pattern file instead of a draft; absolute
  /// Fixed garment size instead of a fit to this body, empty = fit; of a pattern file one of those
  /// that it holds, empty = as it says.
  std::string size;
  std::string units;  ///< of a pattern file: mm, cm, m or inch; empty = as it says
  std::string seams;  ///< side file with the seams of a pattern file, absolute; empty = beside it
  /// By KindKey::name; a missing one has the usual value of the kind.
  std::map<std::string, double> fit;
  /// Names of the fit that nobody asked for: they give way where this body cannot be drafted
  /// otherwise.
  std::vector<std::string> adapt;
  std::vector<pattern::NamedElastic> elastics;  ///< beside those that the pattern has
  std::vector<pattern::NamedCloth> bands;       ///< instead of what the pattern says of the panels
};

/// One garment that is worn: of [garment] and [material], or of an [[under]].
struct ScenarioGarment {
  GarmentSpec spec;
  MaterialCard material;
  /// Against the garments over it; absent: mean of their materials'.
  std::optional<double> friction;
};

/// [simulation]
struct ScenarioSimulation {
  double edge_length = 0.014;  ///< wished triangle edge [m]
  std::string integrator = "quasi-static";
  std::uint64_t seed = 1;
  int repeats = 1;                ///< drapes from perturbed starts: folds are not unique
  double start_perturbation = 0;  ///< rms shift of the dressed start [m]
  /// These four as in DrapeOptions, which has the defaults.
  double residual_tolerance = drape::DrapeOptions{}.residual_tolerance;
  double gravity = drape::DrapeOptions{}.gravity;
  double time_budget = drape::DrapeOptions{}.time_budget;
  int max_iterations = drape::DrapeOptions{}.max_iterations;
  int threads = 0;                 ///< 0 = all cores; results do not depend on it
  std::vector<std::string> notes;  ///< said to the user: keys of earlier files without effect
};

/// [output]
struct ScenarioOutput {
  std::vector<std::string> maps = {"strain", "shear", "distance", "angular-deviation", "crimp"};
  std::vector<std::string> views = {"front", "back"};
  bool undecorated = true;         ///< also pictures of the plain drape
  bool preset_sites = true;        ///< scapulae, back, chest, … in addition to [[site]]
  int width = 900, height = 1000;  ///< pictures [pixels]
};

/// [ranking]: which kind of sensor the sites are judged for at the end of a run.
struct ScenarioRanking {
  std::string modality;  ///< name of a scorecard, or the absolute path of one; empty: no ranking
  int best = 0;          ///< so many places are searched beside the sites
  bool partial = false;  ///< by the criteria that the drapes can tell
};

/// Names of movements, in the order in which they are offered (pipeline/wearer_movements.h).
inline constexpr std::array<const char*, 4> kMovementNames = {"arm-raise", "breath", "hem-pull",
                                                              "fidget"};

inline constexpr int kMostDonnings = 100;

/// [donning]: how the wearer settles the garment once it is on, and putting it on again and again,
/// never quite alike.
struct ScenarioDonning {
  /// In this order, by name, each at most once. Empty: none.
  std::vector<std::string> movements{kMovementNames.begin(), kMovementNames.end()};
  double movement_spread = 0.3;  ///< standard deviation of ln of their sizes in further donnings
  int repeats = 1;
  bool first_drawn = false;      ///< as the others are; else the first is undisturbed
  double shift = 0.010;          ///< of the garment, each axis, to either side [m]
  double twist = radians(10.0);  ///< on the trunk, to either side [rad]
  double friction_spread = 0.2;  ///< standard deviation of ln μ
  std::uint64_t seed = 1;
};

/// Everything `loosefit run` is asked to do; every default written out. Documented key by key in
/// docs/scenario.md.
struct Scenario {
  std::string file;  ///< where it was read from, for messages; not part of the resolved text
  std::map<std::string, int> lines;  ///< where each key stands in it ("attachment[0].at"), likewise
  ScenarioBody body;
  std::vector<ScenarioGarment> garments{1};  ///< the innermost first; the last one is studied
  std::vector<garment::Attachment> attachments;
  std::vector<placement::SiteSpec> sites;
  ScenarioSimulation simulation;
  ScenarioOutput output;
  ScenarioRanking ranking;
  /// [postures]: names (body/named_postures.h); the first is `body.posture`, in which the maps are
  /// made and sensors are calibrated. Empty: only body.posture.
  std::vector<std::string> postures;
  ScenarioDonning donning;

  /// The garment that is studied: the outermost.
  ScenarioGarment& studied() { return garments.back(); }
  const ScenarioGarment& studied() const { return garments.back(); }
  /// The garments under it, the innermost first.
  std::span<const ScenarioGarment> worn_under() const {
    return std::span(garments).first(garments.size() - 1);
  }
};

}  // namespace loosefit::scenario
