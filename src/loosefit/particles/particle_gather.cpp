#include "loosefit/particles/particle_gather.h"

#include <algorithm>

#include "loosefit/particles/tile.h"

namespace loosefit::particles {

ParticleGather::ParticleGather(const std::vector<int>& particle) {
  int particles = 0;
  for (int p : particle) particles = std::max(particles, p + 1);
  start_.assign(particles + 1, 0);
  for (int p : particle)
    if (p >= 0) ++start_[p + 1];
  for (int p = 0; p < particles; ++p) start_[p + 1] += start_[p];
  corner_.resize(start_.back());
  std::vector<int> next(start_.begin(), start_.end() - 1);
  for (std::size_t c = 0; c < particle.size(); ++c)
    if (particle[c] >= 0) corner_[next[particle[c]]++] = static_cast<int>(c);
}

void ParticleGather::add_to(int p, const std::vector<Vec3>& force, VectorField& g) const {
  double sum[3] = {0, 0, 0};
  for (int k = start_[p]; k < start_[p + 1]; ++k) {
    const double* f = force[corner_[k]].data();
    for (int c = 0; c < 3; ++c) sum[c] += f[c];
  }
  for (int c = 0; c < 3; ++c) g[p][c] += sum[c];
}

void ParticleGather::add(const std::vector<Vec3>& force, VectorField& g) const {
  for_ranges(static_cast<int>(start_.size()) - 1, 512, [&](int begin, int end) {
    for (int p = begin; p < end; ++p) add_to(p, force, g);
  });
}

void ParticleGather::add(const std::vector<Vec3>& force, VectorField& g,
                         const ActiveSet* active_set) const {
  if (!active_set) return add(force, g);
  const int particles = static_cast<int>(start_.size()) - 1;
  for (int p : active_set->particles)
    if (p < particles) add_to(p, force, g);
}

}  // namespace loosefit::particles
