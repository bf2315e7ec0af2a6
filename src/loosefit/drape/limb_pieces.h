#pragma once
#include <vector>

#include "loosefit/body/posed_body.h"
#include "loosefit/drape/openings.h"
#include "loosefit/drape/polyline.h"
#include "loosefit/garment/open_seams.h"

namespace loosefit::drape {

/// Pieces of cloth that are worn on one limb by themselves: socks, gloves, hats, leg warmers, arm
/// bands. They go with their limb from where the file places them to the posture of the wearer:
///
/// * a piece round its limb keeps its place there; one that lies beside it is moved onto it, that
///   of an arm turned along the arm;
/// * a piece with one opening is moved along the limb until its closed end is at the end of the
///   limb, unless they agree within 3 cm;
/// * any is moved across the limb by as little as makes it enclose what it covers of it;
/// * panels that are sewn to themselves are rolled round the limb, others move along their outside
///   normals until they are clear of the limb.
class LimbPieces {
 public:
  /// \param openings as the wearer tells them. Keeps references to `open` and `body`.
  LimbPieces(const garment::Garment& sewn, const garment::OpenSeams& open,
             const std::vector<Opening>& openings, const body::PosedBody& body);
  bool has(int panel) const { return of_panel_[panel] >= 0; }
  /// Moves their vertices in x, which begin as placed [m], and turns the unit normals of their
  /// panels; that of a rolled one becomes zero. \throws GeometryError for a glove with fingers:
  /// contact takes a hand as a closed shape.
  void lay(const pattern::Pattern& pattern, std::vector<Vec3>& x, std::vector<Vec3>& outside) const;

 private:
  struct Piece {
    Limb limb;
    Vec3 upper, lower;  ///< middles of the openings as placed; of a single one both are it [m]
    bool is_round;      ///< its limb, as placed
    bool one_ended;
    std::vector<int> vertices;  ///< of open.garment
  };
  void lay_piece(const Piece& piece, const pattern::Pattern& pattern, std::vector<Vec3>& x,
                 std::vector<Vec3>& outside) const;
  /// Shifts a piece to the end of its limb, if it has one opening, and across until it encloses
  /// what it covers. `outwards`: unit vector along the limb.
  void enclose(const Piece& piece, const Vec3& outwards, std::vector<Vec3>& x) const;
  /// Whether the panel was rolled round the limb, which has no one normal.
  bool clear_limb(int panel, const Piece& piece, const Mat3& frame, std::vector<Vec3>& x) const;
  bool is_of_limb(Limb limb, std::size_t skin_vertex) const;

  const garment::OpenSeams& open_;
  const body::PosedBody& body_;
  LimbLines at_rest_, worn_;
  std::vector<int> of_panel_;  ///< index of the piece; −1: none
  std::vector<Piece> pieces_;
};

}  // namespace loosefit::drape
