#include "loosefit/drape/settling_budget.h"

#include <cmath>

namespace loosefit::drape {

double SettlingBudget::seconds() const {
  return std::chrono::duration<double>(Clock::now() - start_).count();
}

bool SettlingBudget::time_is_up() const {
  return seconds() > options_.time_budget * options_.drapes_at_once;
}

void SettlingBudget::count(int iterations, bool explicit_steps) {
  iterations_ += iterations;
  const double worth = explicit_steps ? 1.0 / options_.tuning.integrators.explicit_steps : 1.0;
  spent_ += worth * iterations;
}

int SettlingBudget::iterations_left() const {
  return std::max(0, static_cast<int>(std::ceil(options_.max_iterations - spent_)));
}

}  // namespace loosefit::drape
