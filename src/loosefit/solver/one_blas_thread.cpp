#include "loosefit/solver/one_blas_thread.h"

#include <mutex>

extern "C" {
int openblas_get_num_threads(void);
void openblas_set_num_threads(int count);
}

namespace loosefit::solver {
namespace {

struct Holders {
  std::mutex mutex;
  int count = 0;
  int threads_before = 1;
};

Holders& holders() {
  static Holders all;
  return all;
}

}  // namespace

OneBlasThread::OneBlasThread() {
  const std::lock_guard lock(holders().mutex);
  if (holders().count++ > 0) return;
  holders().threads_before = openblas_get_num_threads();
  openblas_set_num_threads(1);
}

OneBlasThread::~OneBlasThread() {
  const std::lock_guard lock(holders().mutex);
  if (--holders().count == 0) openblas_set_num_threads(holders().threads_before);
}

}  // namespace loosefit::solver
