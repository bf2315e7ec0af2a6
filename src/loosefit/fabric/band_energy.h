#pragma once
#include <vector>

#include "loosefit/particles/energy.h"

namespace loosefit::fabric {

/// A triangle under a band.
struct BandTriangle {
  int triangle = 0;
  Vec3 row = Vec3::Zero();  ///< Σ row_k x_k = image of the band's unit direction [1/m]
  double share = 0;         ///< of the part's area; they sum to 1
};

/// A part of a band that is stretched as one: about as long as an edge of the mesh.
struct BandPart {
  std::vector<BandTriangle> triangles;
  double length = 0;       ///< in the flat cloth [m]
  double stiffness = 0;    ///< EA: force per elongation [N]
  double pre_stretch = 0;  ///< p, by which it is longer on the flat cloth than by itself [–]
};

/// Elongation over which a band takes up its slack [–]: threads and knitted tapes straighten their
/// crimp (judgement; it takes half of this, 0.1 %, off the elongation that carries).
inline constexpr double kBandSlackElongation = 0.002;

/// Force per EA of a band at elongation e, and its integral and derivative over e [–]. No band
/// pushes: 0 up to e = 0, e²/2ε up to e = ε = kBandSlackElongation, e − ε/2 beyond.
struct BandLaw {
  double energy = 0, force = 0, tangent = 0;
};
BandLaw band_law(double elongation);

/// Narrow bands that are sewn on along their length and pull on the cloth: stretch sensors,
/// elastics, leads. Of each part, with V_t = Σ_k row_k x_k the image of its direction in triangle
/// t,
///
///   λ = Σ_t share_t |V_t|,  e = (1 + p) λ − 1,  Π = EA L/(1 + p) Φ(e)                 [J]
///
/// Φ the integral of band_law, L/(1 + p) the band's own length. One elongation for a part, not one
/// for a triangle, lest a stiff band lock the triangles under it (MembraneEnergy). Convex.
class BandEnergy : public particles::Energy {
 public:
  /// `triangles` in the numbers of the particles.
  BandEnergy(std::vector<Triangle> triangles, std::vector<BandPart> parts)
      : triangles_(std::move(triangles)), parts_(std::move(parts)) {}

  double value(const particles::VectorField& x) const override;
  void add_gradient(const particles::VectorField& x, particles::VectorField& g) const override;
  void add_pattern(const particles::VectorField& x,
                   particles::BlockPattern& pattern) const override;
  void add_hessian(const particles::VectorField& x, particles::BlockMatrix& h,
                   particles::HessianKind kind) const override;
  bool empty() const { return parts_.empty(); }

 private:
  double elongation(const BandPart& part, const particles::VectorField& x) const;
  /// ∂λ/∂x of a part: its particles, ascending, and their vectors.
  struct Slope {
    std::vector<int> particles;
    std::vector<Vec3> slopes;
  };
  Slope slope(const BandPart& part, const particles::VectorField& x) const;

  std::vector<Triangle> triangles_;
  std::vector<BandPart> parts_;
};

}  // namespace loosefit::fabric
