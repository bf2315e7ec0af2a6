#pragma once
#include <array>
#include <string>
#include <variant>
#include <vector>

namespace loosefit::drape {

// Every tuning number of the drape module in one struct, one group per phase. None changes what is
// an equilibrium; they decide whether and how fast it is found, unless a field says otherwise.
// "D5" stands for docs/decisions/0005-dressing-and-settling.md, "E" for the experiments of
// bench/reports/engine.md, "F" for those of bench/reports/following-the-body.md. Residuals are
// ‖F‖₂/‖W‖₂ [–], pseudo-steps in seconds. Limits of numbers that are worn or certified are no
// tuning: they stand with their tests (drape/worn.cpp, solver/rest_tolerance.h).

/// Energies of the cloth (ClothModel).
struct ClothModelTuning {
  /// Pressure that would compress half the thickness of a fabric of `reference_stiffness` by the
  /// linear part of the law [Pa]: above the pressures of clothing; changes the gap of pressed cloth
  /// by a fraction of its thickness.
  double layer_pressure = 5000;
  /// Membrane stiffness from which on a fabric presses harder in proportion [N/m]; that of the
  /// paper's cotton.
  double reference_stiffness = 2000;
  /// Elastic creep of a contact before it slips [m]. A fifth of a thin fabric; friction is exact
  /// beyond it (D5, "Friction").
  double stick_reach = 1e-4;
  /// Damping time of the explicit integrator, in times that a wave takes through the smallest
  /// triangle [–]: stability of explicit viscosity needs much less than 1.
  double wave_share = 0.1;
  /// Distance between cloth and cloth on coarse levels, in thicknesses [–]: leaves room for the
  /// curved surface of the next level. Chosen by experiment, with the levels of D5.
  double coarse_thickness = 2.0;
};

/// The field of distances to the skin (ContactBody), and how cloth is carried along with the skin.
struct CarryTuning {
  /// Margin of the field round the cloth [m], and more of it below: hems sink while cloth settles.
  /// Cloth that leaves it gets a new field (recoveries.h); chosen by experiment.
  double field_margin = 0.06;
  double field_margin_below = 0.10;
  /// Length over which the motion of the skin is smoothed along the cloth [m]: about the width of a
  /// fold, so that folds turn as a whole; chosen by experiment.
  double smoothing_length = 0.04;
  /// Passes of smoothing at most [–]: bounds the work on fine meshes.
  int smoothing_passes = 50;
  /// Spacing of the field while the coarsest level follows the body [m]: half the accuracy, an
  /// eighth of the nodes; F.
  double rough_field_spacing = 0.010;
  /// Distance to the layer below up to which a layer moves as that one [m]; chosen by experiment, F
  /// has no other value.
  double layer_close = 0.005;
  /// Distance from which on it moves by itself [m]; between the two, in proportion.
  double layer_apart = 0.04;
  /// Rounds in which cloth that would meet is joined to rigid zones [–]: each joins at least two
  /// particles, in practice a handful of rounds suffice; chosen by experiment.
  int impact_rounds = 30;
};

/// The strained start contracts.
struct ContractTuning {
  /// Thickness of the soft layer between body and cloth until the cloth stands in its posture [m]:
  /// contacts then come one after another over millimetres and not all within the last tenth of
  /// one, so Newton's steps stay whole and nothing is pulled through the skin (D5: a soft wool
  /// shirt went from 2 049 iterations without being dressed to 45).
  double pad_thickness = 0.005;
  /// Shares of the membrane stiffness with which it contracts first [–], without friction and
  /// weight, so that it comes to lie on the limbs and is not pulled through them (D5, "Start").
  std::array<double, 2> stiffness_shares = {0.01, 0.1};
  /// Residual at which a softened contraction is good enough [–]; chosen by experiment, see E.
  double softened_tolerance = 30;
  /// Residual at which the dressed coarse level may move on [–]; E, row "dressed at 5".
  double dressed_tolerance = 5;
  /// First pseudo-step of all these [s]: the start is far from rest; chosen by experiment.
  double first_dt = 0.01;
  /// Iterations of each softened contraction, at most [–]; chosen by experiment.
  int softened_iterations = 60;
};

/// The start is disturbed, for repeats and donnings.
struct DisturbTuning {
  /// Wave of the seeded shift along height and width [1/m]: lengths of 0.3 and 0.5 m, of the size
  /// of folds. Any smooth field would do.
  double wave_height = 20;
  double wave_width = 12;
  /// Amplitude of the wave over the mean shift [–].
  double wave_amplitude = 0.5;
  /// Residual after each step of a donning's shift and twist [–]; as dressed_tolerance.
  double tolerance = 5;
  /// First pseudo-step of each [s]; as ContractTuning::first_dt.
  double first_dt = 0.01;
  /// Steps in which it is shifted and twisted [–]: 10 mm and 10° in steps that contact can follow.
  int steps = 4;
  /// Iterations after each, at most [–]; as StepPlan::iterations.
  int iterations = 25;
};

/// How a posture is followed: one step of the body, then settling.
struct StepPlan {
  double turn = 0.4;        ///< largest rotation of any skin in one step [rad]
  double tolerance = 1000;  ///< residual after a step [–]: no more than a stage on the way
  int iterations = 8;  ///< for it, at most [–]: 25 of them gave the same drape; F, "Short steps"
};

/// The wearer moves once the garment is on (phases/wear_in.h); the body's steps are those of
/// FollowTuning.
struct WearInTuning {
  /// Residual after a pull on the hem and after letting go [–]: well below the pull itself, which
  /// is about 20.
  double pull_tolerance = 5;
  double first_dt = 0.02;   ///< first pseudo-step of both [s]; as FollowTuning::first_dt
  int pull_iterations = 8;  ///< of both, at most [–]; as StepPlan::iterations
};

/// The body moves, the cloth goes along.
struct FollowTuning {
  StepPlan plan = {};  ///< F; half the turn gave the same states at twice the fields
  /// Residual after a step, in StepPlan::tolerance, beyond which it is settled longer [–]: cloth
  /// pressed deep into the skin would be pulled through it on the next step. Experiment.
  double lagging = 50;
  /// Share of its displacement that one layer must be free to go, or the step is halved [–]: all of
  /// it but round-off. Otherwise the body would pass through the cloth.
  double free_share = 0.999;
  /// The same of several layers [–]: they touch, so that a little is always cut off.
  double layers_free_share = 0.9;
  /// Depth in the skin after a step for which it is halved [m]; F.
  double deepest = 0.012;
  /// The same in thin limbs: a step is halved when cloth comes to lie deeper than this part of the
  /// way to the middle of the limb, 1/(1 + limb_share) [–]; hands are 25 mm thick, and of cloth 8
  /// mm deep in one some came out on the other side. Only cloth deeper than `shallow` [m] is asked,
  /// and such as the step takes `deeper` than it lies [m].
  double limb_share = 2;
  double shallow = 0.002;
  double deeper = 0.001;
  /// Depth in the skin near rest at which the cloth counts as caught between folds of skin [m];
  /// F, "Given up".
  double caught_depth = 0.005;
  double caught_tolerance = 100;  ///< residual at which that is asked [–]; F, as above
  /// First pseudo-step after each step of the body [s]; chosen by experiment.
  double first_dt = 0.02;
  /// First pseudo-step on the finest level, before it is asked whether cloth is caught [s].
  double finest_first_dt = 0.1;
  /// Rotation below which a body has not moved [rad]: round-off of a posture.
  double no_turn = 1e-6;
  /// Settling longer has so many times the iterations of StepPlan [–]; chosen by experiment.
  int longer = 25;
  /// A step may be shortened to this part of the usual one [–]: four halvings; D5, "The body waits
  /// for the cloth".
  int shortest = 16;
  /// A step shorter than so many times the shortest one is not halved again [–], and what would be
  /// left beyond the next step is taken along when it is shorter than this part of it [–]: neither
  /// leaves steps below the shortest.
  double halved_from = 1.5;
  double taken_along = 0.5;
  /// Every how manieth skin vertex is asked for its rotation [–]: neighbours turn alike.
  int sampled_skin = 7;
  /// A posture is given up after so many times the finest iterations of putting on [–], and not
  /// before `least_iterations`; F, "Given up".
  int iterations_factor = 3;
  int least_iterations = 500;
};

/// Coarse levels are settled and handed to the next finer one.
struct LevelTuning {
  /// Residual at which a level is handed on [–]; E, row "handed on at 1"; F tried 0.1 and 0.01.
  double tolerance = 1.0;
  double first_dt = 0.02;  ///< first pseudo-step [s]; chosen by experiment
  /// Iterations of a level, at most [–]: the next one goes on where they end. The reference shirt
  /// takes 130 on the coarse level; half as many are enough for the finest, but postures are
  /// followed from here, and what is not at rest would move.
  int iterations = 150;
};

/// The finest level comes to rest, and triangles that cut the skin are freed.
struct PenetrationTuning {
  /// Residuals on the way down at which penetrations are looked for [–], and the first pseudo-step
  /// of each part [s]; E, "Cuts are looked for on the way".
  std::array<double, 3> look_tolerances = {30, 5, 1};
  std::array<double, 3> look_first_dt = {0.1, 0.5, 2.5};
  /// Share of the hardening that the layer on the skin has on the way to each look [–]. Points that
  /// are found late lie deep in it, and all of it would throw the cloth off: 135 iterations on the
  /// finest level of the reference shirt, with these shares 112.
  std::array<double, 3> look_hardening = {0, 0, 0.1};
  /// Residual at which the last penetrations are looked for [–]; E, "at 1 instead of 0.1".
  double tolerance = 1.0;
  double first_dt = 0.5;  ///< first pseudo-step of the rest of the way [s]; chosen by experiment
  /// First pseudo-step where the cloth is near rest [s]: nearly static, yet damped; experiment.
  double near_rest_dt = 10;
  /// Largest interval of the lattice of contact points near the skin [m]: finer than the field's
  /// spacing and the faces of the skin.
  double lattice_spacing = 0.0035;
  /// How far the skin may bulge into a cell of the lattice from its corners [m], and by how much it
  /// must, for a point of its own there [m].
  double bulge = 1.5e-4, worth_a_point = 2e-5;
  /// The search for that place: intervals along an edge of the cell to begin with [–], and the last
  /// step in edges [–], a few hundredths of a millimetre.
  int cell_intervals = 4;
  double least_step = 0.01;
  /// Rounds at rest in which contact points are added before offsets are raised [–]: one. More of
  /// them take 1.8 times the iterations at 10 mm edges for as many triangles held off.
  int exact_rounds = 1;
  /// Clearance asked of a triangle that still cuts after them [m]: more than the exact test needs.
  double clearance = 1.2e-4;
  /// More of it each time [m]; a fixed offset took up to sixteen rounds (D5, "Rejected").
  double clearance_each_time = 3e-5;
  /// Clearance below which a triangle is treated alike [m]: or each round would find neighbours.
  double near_penetration = 4e-5;
  /// Largest raise of an offset in one round [m].
  double largest_raise = 5e-4;
  /// Largest error of the distance field that is taken off what it reads [m]: beyond it the cloth
  /// lies in a wedge of skin, where nearest places jump.
  double largest_field_error = 0.002;
  /// Distance from the skin from which on contact is refined and errors are measured [m].
  double far = 0.002;
  /// Iterations before each look, at most [–]; E.
  int look_iterations = 15;
  /// Rounds at rest in which cuts are freed [–]: a handful is usual; a stop for hopeless ones.
  int rounds = 30;
};

/// The certificate is met, or the best state is taken.
struct CertifyTuning {
  /// First share of the tolerance that is sought when the certificate, which refreshes contacts,
  /// finds more than it allows [–], and the factor from one attempt to the next.
  double first_share = 0.8;
  double next_share = 0.5;
  int attempts = 3;  ///< [–]; chosen by experiment
  /// How often a saddle is left [–], and how far the particle that goes farthest goes then [m]:
  /// two thicknesses of a fabric, so that it comes clear of what held it.
  int saddle_attempts = 3;
  double saddle_step = 1e-3;
  /// A garment is put on once more where no more triangles than these cut [–]: many tell that there
  /// is no room.
  int few_triangles = 60;
  /// Least rms shift of the start when the garment is put on once more [m]: which of many folds
  /// forms hangs on less (docs/accuracy.md 3).
  double restart_perturbation = 1e-3;
  /// Fall of the residual that makes a state worth keeping [–]: a copy costs a tenth of an
  /// iteration.
  double worth_keeping = 0.7;
};

/// A drape that gets no nearer to rest is given up, and may start once more (recoveries.h).
struct StallTuning {
  /// So many iterations on the finest level in which the lowest residual has not fallen to this
  /// share of what it was [–]. A choice: a tube that snaps to and fro between two shapes, or slides
  /// down the legs, goes on for thousands.
  int iterations = 1500;
  double progress = 0.7;
  /// Cloth whose middle has sunk by so much meanwhile slides down the body, and does not start once
  /// more [m]: what only folds sinks by millimetres.
  double slides = 0.02;
};

/// Cloth that nothing holds is recognised (FreeFall).
struct FreeFallTuning {
  /// Pieces whose boxes come so near may hang on each other [m].
  double together = 0.02;
  /// How far beside the body cloth has to be, beyond all that it reaches [m]: for friction and
  /// bulk.
  double aside = 0.10;
};

/// The two integrators of comparison.
struct IntegratorTuning {
  double implicit_dt = 0.02;  ///< time step of implicit Euler [s]; stable at any
  int explicit_steps = 1000;  ///< steps of the paper's integrator that count as an iteration [–]
};

/// All of them.
struct SettlingTuning {
  ClothModelTuning cloth;
  CarryTuning carry;
  ContractTuning contract;
  DisturbTuning disturb;
  FollowTuning follow;
  WearInTuning wear_in;
  LevelTuning levels;
  PenetrationTuning penetrations;
  CertifyTuning certify;
  StallTuning stall;
  FreeFallTuning free_fall;
  IntegratorTuning integrators;

  /// \throws InvalidInput naming field, value and bounds of the first that is out of bounds.
  void validate() const;
};

/// One number of a tuning by its name ("contract.pad_thickness"), for sweeps and tests.
struct TuningField {
  std::string name;
  std::variant<double*, int*> value;  ///< in the tuning
  double least, most;                 ///< bounds, both allowed
};

/// All numbers of `tuning`, in the order of their declaration. They point into it.
std::vector<TuningField> tuning_fields(SettlingTuning& tuning);

}  // namespace loosefit::drape
