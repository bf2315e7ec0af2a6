// Our multifrontal factor against CHOLMOD's supernodal one, on the matrices of a shirt that
// settles. Every few iterations of a real run both factorise and solve the same system; see
// README.md.
#include <fmt/format.h>
#include <tbb/global_control.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>

#include "../solver/problem.h"
#include "loosefit/base/error.h"
#include "loosefit/solver/integrator.h"
#include "loosefit/solver/linear/cholmod_solver.h"
#include "loosefit/solver/linear/newton_system.h"
#include "loosefit/solver/quasi_static.h"
#include "loosefit/solver/tangent_matrix.h"

extern "C" void openblas_set_num_threads(int);

namespace loosefit {
namespace {

constexpr int kApart = 10;         ///< iterations between two matrices
constexpr double kDt = 10;         ///< pseudo-step of the inertia on the diagonal [s]
constexpr double kAllowed = 2e-3;  ///< relative residual of a solution that counts

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double median(std::vector<double> values) {
  std::ranges::sort(values);
  return values.empty() ? std::nan("") : values[values.size() / 2];
}

/// Seconds of one rival on every matrix.
struct Rival {
  std::string name;
  /// With the analysis of a pattern that is new, and of the numbers alone.
  std::vector<double> first, again, solve;
};

struct System {
  const particles::BlockMatrix& a;
  const std::vector<double>& shift;
  const std::vector<char>& held;
  const std::vector<Vec3>& g;
};

/// ‖A x + g‖ / ‖g‖ over free particles.
double residual(const System& s, const std::vector<Vec3>& x) {
  std::vector<Vec3> r(x.size());
  double rr = 0, gg = 0;
  for (std::size_t i = 0; i < x.size(); ++i) r[i] = s.shift[i] * x[i] + s.g[i];
  s.a.add_product(x, r);
  for (std::size_t i = 0; i < x.size(); ++i)
    if (s.held.empty() || !s.held[i]) rr += r[i].squaredNorm(), gg += s.g[i].squaredNorm();
  return std::sqrt(rr / gg);
}

template <class Factorise, class Solve>
void measure(const System& s, const Factorise& factorise, const Solve& solve, Rival& rival) {
  for (const bool is_first : {true, false}) {
    const double start = now();
    if (!factorise()) throw Error(rival.name + ": the matrix is not definite");
    (is_first ? rival.first : rival.again).push_back(now() - start);
  }
  std::vector<Vec3> x;
  const double start = now();
  solve(x);
  rival.solve.push_back(now() - start);
  if (const double r = residual(s, x); !(r < kAllowed))
    throw Error(fmt::format("{}: a residual of {:.1e}", rival.name, r));
}

void compare(const std::string& name, int threads, int blas_threads, int matrices) {
  const bakeoff::Problem problem = bakeoff::make_problem(name);
  bakeoff::World world = problem.make();
  const solver::ParticleSystem& system = *world.system;
  solver::TangentMatrix tangent(system);
  solver::NewtonSystem own;
  solver::CholmodSolver cholmod;
  Rival ours{"ours", {}, {}, {}}, theirs{"CHOLMOD", {}, {}, {}};
  std::vector<double> shift(system.particles());
  for (int i = 0; i < system.particles(); ++i) shift[i] = system.mass[i] / (kDt * kDt);
  const auto integrator = solver::make_quasi_static(system);
  for (int k = 0; k < matrices; ++k) {
    solver::SettleOptions options;
    options.tolerance = 1e-3;
    options.max_iterations = kApart;
    options.first_dt = problem.first_dt;
    const bool at_rest =
        integrator->settle(world.x, options).reason == solver::SettleOutcome::Reason::converged;
    system.begin_step(world.x, kDt);
    tangent.assemble(world.x, particles::HessianKind::projected);
    const std::vector<Vec3> g = system.gradient(world.x);
    const System s{tangent.matrix(), shift, system.held, g};
    std::vector<Vec3> b(g.size());
    for (std::size_t i = 0; i < g.size(); ++i) b[i] = -g[i];
    measure(
        s, [&] { return own.factorise(s.a, shift, system.held); },
        [&](std::vector<Vec3>& x) { own.solve(g, x); }, ours);
    openblas_set_num_threads(blas_threads);
    measure(
        s, [&] { return cholmod.factorise(s.a, shift, system.held); },
        [&](std::vector<Vec3>& x) { cholmod.solve(b, x); }, theirs);
    openblas_set_num_threads(1);
    if (at_rest) break;
  }
  const auto ms = [](const std::vector<double>& seconds) { return 1e3 * median(seconds); };
  const auto whole = [&](const Rival& r, bool is_new) {
    return (is_new ? ms(r.first) : ms(r.again)) + ms(r.solve);
  };
  for (const Rival* r : {&ours, &theirs})
    fmt::print("{:11} {:8} {:6} {:8} {:12.1f} {:12.1f} {:10.2f}\n", name, problem.vertices, threads,
               r->name, ms(r->first), ms(r->again), ms(r->solve));
  fmt::print(
      "{:11} CHOLMOD / ours, factor and solve: new pattern {:.2f}, same pattern {:.2f}; "
      "{} matrices\n",
      name, whole(theirs, true) / whole(ours, true), whole(theirs, false) / whole(ours, false),
      ours.first.size());
  std::fflush(stdout);
}

int run(int argc, char** argv) {
  std::vector<std::string> problems = {"shirt-14mm", "shirt-10mm", "shirt-5mm"};
  int threads = 1, blas_threads = 0, matrices = 20;
  CLI::App app{"Our factor against CHOLMOD's on the matrices of a shirt that settles"};
  app.add_option("--problems", problems)->check(CLI::IsMember(bakeoff::problem_names()));
  app.add_option("--threads", threads, "of ours, and of CHOLMOD's BLAS unless told otherwise")
      ->check(CLI::Range(1, 256));
  app.add_option("--blas-threads", blas_threads, "of CHOLMOD's BLAS")->check(CLI::Range(1, 256));
  app.add_option("--matrices", matrices, "at most, of each")->check(CLI::Range(1, 1000));
  CLI11_PARSE(app, argc, argv);
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  fmt::print("{:11} {:>8} {:>6} {:8} {:>12} {:>12} {:>10}\n", "problem", "vertices", "cores", "",
             "factor ms", "again ms", "solve ms");
  for (const std::string& name : problems)
    compare(name, threads, blas_threads > 0 ? blas_threads : threads, matrices);
  return 0;
}

}  // namespace
}  // namespace loosefit

int main(int argc, char** argv) try {
  return loosefit::run(argc, argv);
} catch (const std::exception& error) {
  fmt::print(stderr, "error: {}\n", error.what());
  return 1;
}
