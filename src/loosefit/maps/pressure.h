#pragma once
#include <map>
#include <optional>
#include <vector>

#include "loosefit/body/posed_body.h"
#include "loosefit/drape/drape.h"
#include "loosefit/fabric/material.h"
#include "loosefit/garment/garment.h"

namespace loosefit::maps {

/// Contact pressure between cloth and body by two independent estimates
/// (docs/theory/validation.md 6.2; for the second: generalised Laplace law, e.g. Teyeme et al.
/// 2021). All per garment vertex.
///
/// `contact`: p_i = f_i / a_i with Drape::body_normal_force f_i [N] and the worn area a_i: a third
/// of the triangles round the vertex as they are now. Nothing is smoothed beyond the contact
/// points' own shape functions, so Σ p_i a_i is the total normal force to rounding. Zero where
/// nothing is touched.
///
/// `membrane`: p = N : κ + w n_z, not below zero. N = F S Fᵀ/J is the membrane tension per worn
/// length [N/m] of each triangle, compression included; κ the curvature tensor of the body under
/// the cloth, carried out to the cloth's middle surface (maps/surface_curvature.h), positive where
/// convex; w the weight per worn area; n the body's normal. It is taken at the middles of a
/// triangle's edges (exact for quadratic fields), lumped on the vertices, then clipped. A triangle
/// counts where it touches: the gap under the middle of one of its edges is within the contact
/// tolerance, or all its corners are pressed by the body (cloth that is held off). Elsewhere it is
/// zero.
struct PressureField {
  std::vector<double> contact, membrane;  ///< [Pa]
  std::vector<double> area;               ///< worn area a_i [m²]
  std::vector<char> touching;             ///< 1: at a touching triangle, or pressed by the body

  bool empty() const { return contact.empty(); }
};

/// Largest gap between the cloth's inner face and the skin that counts as contact [m]: three
/// quarters of the thickness (1.5 × the contact offset), at least 0.5 mm
/// (docs/theory/sensor_metrics.md 4).
double contact_tolerance(const fabric::Material& material);

/// \throws InvalidInput when the drape does not know its normal forces, or when sizes differ.
PressureField contact_pressure(const garment::Garment& garment, const drape::Drape& drape,
                               const body::PosedBody& body, const fabric::Material& material,
                               double gravity = kGravity);

/// Membrane tension N = F S Fᵀ/J of each triangle as worn, a 3×3 tensor in its plane [N/m].
std::vector<Mat3> membrane_tension(const garment::Garment& garment,
                                   const std::vector<Vec3>& positions,
                                   const fabric::Material& material);

/// How the two estimates compare over the touching cloth (or the part of it in a region).
struct PressureAgreement {
  double contact_area = 0;    ///< worn area that touches [m²]
  double contact_mean = 0;    ///< area mean of the contact-force estimate [Pa]
  double membrane_mean = 0;   ///< of the membrane estimate [Pa]
  double contact_force = 0;   ///< total normal force [N], Σ p a
  double membrane_force = 0;  ///< the same by the membrane estimate [N]
  double rms_difference = 0;  ///< area-weighted, of membrane − contact [Pa]
  double correlation = 0;     ///< Pearson, area-weighted; NaN when one of them is constant
};
/// Means and rms are NaN without contact. Only vertices with `regions[i] == *only` if given.
PressureAgreement compare_pressures(const PressureField& field,
                                    const std::vector<body::Region>& regions,
                                    std::optional<body::Region> only = {});

/// Bounds of the classes of docs/theory/sensor_metrics.md 5 [Pa], and the classes from no contact
/// on: below the first bound an electrode is unreliable, then marginal, then good, then firm, and
/// above the last bound the wearer is uncomfortable.
inline constexpr double kPressureClasses[] = {300, 700, 2700, 4000};
inline constexpr const char* kPressureClassNames[] = {"none", "unreliable", "marginal",
                                                      "good", "firm",       "uncomfortable"};
/// Share of the worn area in each class by the contact-force estimate; they sum to one.
std::vector<double> pressure_class_shares(const PressureField& field);

}  // namespace loosefit::maps
