#include "loosefit/fabric/band_energy.h"

#include <algorithm>

namespace loosefit::fabric {
namespace {

Vec3 image(const BandTriangle& t, const Triangle& v, const particles::VectorField& x) {
  return t.row[0] * x[v[0]] + t.row[1] * x[v[1]] + t.row[2] * x[v[2]];
}

}  // namespace

BandLaw band_law(double elongation) {
  constexpr double kSlack = kBandSlackElongation;
  if (elongation <= 0) return {};
  if (elongation < kSlack)
    return {elongation * elongation * elongation / (6 * kSlack),
            elongation * elongation / (2 * kSlack), elongation / kSlack};
  const double beyond = elongation - kSlack;
  return {kSlack * kSlack / 6 + 0.5 * kSlack * beyond + 0.5 * beyond * beyond,
          elongation - 0.5 * kSlack, 1};
}

double BandEnergy::elongation(const BandPart& part, const particles::VectorField& x) const {
  double stretch = 0;
  for (const BandTriangle& t : part.triangles)
    stretch += t.share * image(t, triangles_[t.triangle], x).norm();
  return (1 + part.pre_stretch) * stretch - 1;
}

BandEnergy::Slope BandEnergy::slope(const BandPart& part, const particles::VectorField& x) const {
  Slope slope;
  for (const BandTriangle& t : part.triangles)
    for (const int v : triangles_[t.triangle]) slope.particles.push_back(v);
  std::sort(slope.particles.begin(), slope.particles.end());
  slope.particles.erase(std::unique(slope.particles.begin(), slope.particles.end()),
                        slope.particles.end());
  slope.slopes.assign(slope.particles.size(), Vec3::Zero());
  for (const BandTriangle& t : part.triangles) {
    const Triangle& v = triangles_[t.triangle];
    const Vec3 along = t.share * image(t, v, x).stableNormalized();
    for (int k = 0; k < 3; ++k) {
      const auto at = std::lower_bound(slope.particles.begin(), slope.particles.end(), v[k]);
      slope.slopes[at - slope.particles.begin()] += t.row[k] * along;
    }
  }
  return slope;
}

double BandEnergy::value(const particles::VectorField& x) const {
  double sum = 0;
  for (const BandPart& part : parts_)
    sum += part.stiffness * part.length / (1 + part.pre_stretch) *
           band_law(elongation(part, x)).energy;
  return sum;
}

void BandEnergy::add_gradient(const particles::VectorField& x, particles::VectorField& g) const {
  for (const BandPart& part : parts_) {
    const double force = part.stiffness * part.length * band_law(elongation(part, x)).force;
    if (force == 0) continue;
    const Slope s = slope(part, x);
    for (std::size_t i = 0; i < s.particles.size(); ++i) g[s.particles[i]] += force * s.slopes[i];
  }
}

void BandEnergy::add_pattern(const particles::VectorField& x,
                             particles::BlockPattern& pattern) const {
  for (const BandPart& part : parts_) {
    const std::vector<int> all = slope(part, x).particles;
    for (const int a : all)
      for (const int b : all)
        if (a < b) pattern.add(a, b);
  }
}

void BandEnergy::add_hessian(const particles::VectorField& x, particles::BlockMatrix& h,
                             particles::HessianKind) const {
  for (const BandPart& part : parts_) {
    const BandLaw law = band_law(elongation(part, x));
    if (law.tangent == 0) continue;
    const double pull = part.stiffness * part.length * law.force;
    const double stiff = part.stiffness * part.length * (1 + part.pre_stretch) * law.tangent;
    // How the length of the part changes.
    const Slope s = slope(part, x);
    for (std::size_t i = 0; i < s.particles.size(); ++i)
      for (std::size_t j = i; j < s.particles.size(); ++j)
        h.add(s.particles[i], s.particles[j], stiff * s.slopes[i] * s.slopes[j].transpose());
    // How its direction changes.
    for (const BandTriangle& t : part.triangles) {
      const Triangle& v = triangles_[t.triangle];
      const Vec3 way = image(t, v, x);
      const double length = way.norm();
      if (!(length > 0)) continue;
      const Vec3 along = way / length;
      const Mat3 turn = pull * t.share / length * (Mat3::Identity() - along * along.transpose());
      for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b)
          if (v[a] <= v[b]) h.add(v[a], v[b], t.row[a] * t.row[b] * turn);
    }
  }
}

}  // namespace loosefit::fabric
