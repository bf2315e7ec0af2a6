#pragma once
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "loosefit/dress/lay_round.h"
#include "loosefit/kinds/fit_stations.h"
#include "loosefit/kinds/named_values.h"
#include "loosefit/kinds/opening_use.h"
#include "loosefit/pattern/pattern.h"

namespace loosefit::kinds {

/// A measure of the body that a draft needs.
struct KindMeasure {
  std::string name;          ///< "hps_to_hem"; "measures.hps_to_hem" in messages
  std::string of_body;       ///< name in Body::measured
  double low = 0, high = 0;  ///< what people have [unit]
  std::string unit = "m";    ///< m or rad
  bool required = true;      ///< false: where it is not known it follows from the others
};

/// A key of [garment.fit].
struct KindKey {
  std::string name;             ///< "chest"
  std::optional<double> usual;  ///< where nothing is asked for; absent: the key has no value then
  double low = 0, high = 0;     ///< what a scenario may ask for
  std::string unit;             ///< as messages say it: "a body-garment mobility", "metres"
  std::string meaning;
  bool mobility = false;   ///< garment girth / body girth − 1: an option is called --fit-NAME
  bool with_size = false;  ///< of making, not of fit: may be asked for beside a size
};

/// A fixed garment: the body it is cut for and its fit.
struct KindSize {
  std::string name;      ///< "women-38"
  NamedValues measures;  ///< by KindMeasure::name
  NamedValues fit;
  std::string source;  ///< where the numbers come from and how sure they are
};

/// What a draft is asked for.
struct DraftRequest {
  BodyMeasures measures;  ///< of the body, by KindMeasure::name; not needed with a size
  std::string size;      ///< fixed garment size instead; empty: none
  NamedValues fit;       ///< by KindKey::name; a missing one has its usual value
  /// What nobody asked for gives way where it cannot be drafted: "fit.sleeve", "measures.neck".
  std::set<std::string> yielding;
};

/// A garment as it was drafted.
struct DraftedGarment {
  pattern::Pattern pattern;
  BodyMeasures measures;           ///< what it was drafted from in the end
  NamedValues fit;
  std::vector<std::string> notes;  ///< one for every value that gave way
  std::string details;             ///< one line for a tailor: what the draft arrived at
};

/// Girth of a garment at one level, and the body's girth that its fit compares it with.
struct FitLevel {
  std::string name;            ///< "chest", "cuff"
  double garment = 0;          ///< on the flat pieces [m]
  std::optional<double> body;  ///< [m]; absent: the body does not say
};

/// Edges that form one opening, by part of panel and edge, and what goes through it; those of
/// pieces that a draft may leave out are among them.
struct KindOpening {
  OpeningUse use = OpeningUse::unknown;
  std::vector<std::pair<std::string, std::string>> edges;  ///< panel part, edge part
};

/// A kind of garment: all that the program knows of it. A value; registry.h lists them all.
struct GarmentKind {
  std::string name;   ///< "t-shirt": in scenarios, on the command line, in Pattern::kind
  std::string title;  ///< "T-shirt"

  std::vector<KindMeasure> measures;
  std::vector<KindKey> keys;
  std::vector<KindSize> sizes;  ///< fixed sizes; none: it is always made to measure

  /// The pattern, with `kind` and parts noted. Empty for a kind that is only read from files.
  /// \throws InvalidInput for what cannot be drafted, with a key "fit.NAME" or "measures.NAME".
  std::function<DraftedGarment(const DraftRequest&)> draft;
  /// Levels of fit measured on the pieces, in the order to print them. `measures`: what is known
  /// of the body; levels that need more are left out. `fit`: what it was drafted from.
  std::function<std::vector<FitLevel>(const pattern::Pattern&, const BodyMeasures& measures,
                                      const NamedValues& fit)>
      levels;

  /// Girths of the pieces along trunk and limbs, every kStationStep; arguments as of `levels`. Empty
  /// for a kind whose pieces do not tell.
  std::function<std::vector<FitStation>(const pattern::Pattern&, const BodyMeasures& measures,
                                        const NamedValues& fit)>
      stations;

  /// How it is laid round the body; empty: sewn there from where its pattern places the panels.
  dress::LayRound lay;
  /// What goes through its openings; empty: told by how the pattern places them
  /// (drape/openings.h).
  std::vector<KindOpening> openings;

  /// Mark of this draft in pattern files; equal for kinds that are recognised alike.
  std::string mark;
  /// Finds out by the seams which panel and edge is which part of the draft and notes it in
  /// Panel::part and PanelEdge::part; false, with the pattern unchanged, for another garment.
  std::function<bool(pattern::Pattern&)> note_parts;
};

}  // namespace loosefit::kinds
