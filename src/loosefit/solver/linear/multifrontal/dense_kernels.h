#pragma once
#include <cblas.h>

#include "loosefit/solver/linear/multifrontal/kernel_seat.h"

extern "C" {
void spotrf_(const char* uplo, const int* n, float* a, const int* lda, int* info);
void dpotrf_(const char* uplo, const int* n, double* a, const int* lda, int* info);
}

/// The BLAS and LAPACK calls of a multifrontal Cholesky factor, for both precisions. All matrices
/// are column major; `ld` is the distance of their columns. \throws std::bad_alloc where there is
/// no memory for the work of a call.
namespace loosefit::solver::dense {

/// Cholesky factor in place of the lower triangle of a, n × n. False: not positive definite.
inline bool factorise(double* a, int n, int ld) {
  const KernelSeat seat;
  int info = 0;
  dpotrf_("L", &n, a, &ld, &info);
  return info == 0;
}
inline bool factorise(float* a, int n, int ld) {
  const KernelSeat seat;
  int info = 0;
  spotrf_("L", &n, a, &ld, &info);
  return info == 0;
}

/// b ← b L⁻ᵀ with L p × p lower, b r × p.
inline void divide_rows(const double* l, int p, double* b, int r, int ld) {
  const KernelSeat seat;
  cblas_dtrsm(CblasColMajor, CblasRight, CblasLower, CblasTrans, CblasNonUnit, r, p, 1, l, ld, b,
              ld);
}
inline void divide_rows(const float* l, int p, float* b, int r, int ld) {
  const KernelSeat seat;
  cblas_strsm(CblasColMajor, CblasRight, CblasLower, CblasTrans, CblasNonUnit, r, p, 1, l, ld, b,
              ld);
}

/// Lower triangle of c −= b bᵀ with b r × p, c r × r packed without gaps.
inline void subtract_square(const double* b, int r, int p, int ld, double* c) {
  const KernelSeat seat;
  cblas_dsyrk(CblasColMajor, CblasLower, CblasNoTrans, r, p, -1, b, ld, 1, c, r);
}
inline void subtract_square(const float* b, int r, int p, int ld, float* c) {
  const KernelSeat seat;
  cblas_ssyrk(CblasColMajor, CblasLower, CblasNoTrans, r, p, -1, b, ld, 1, c, r);
}

/// c −= a bᵀ with a m × p, b n × p, c m × n with columns ld_c apart.
inline void subtract_product(const double* a, int m, const double* b, int n, int p, int ld,
                             double* c, int ld_c) {
  const KernelSeat seat;
  cblas_dgemm(CblasColMajor, CblasNoTrans, CblasTrans, m, n, p, -1, a, ld, b, ld, 1, c, ld_c);
}
inline void subtract_product(const float* a, int m, const float* b, int n, int p, int ld, float* c,
                             int ld_c) {
  const KernelSeat seat;
  cblas_sgemm(CblasColMajor, CblasNoTrans, CblasTrans, m, n, p, -1, a, ld, b, ld, 1, c, ld_c);
}

/// y ← L⁻¹ y.
inline void solve_lower(const double* l, int p, int ld, double* y) {
  const KernelSeat seat;
  cblas_dtrsv(CblasColMajor, CblasLower, CblasNoTrans, CblasNonUnit, p, l, ld, y, 1);
}
inline void solve_lower(const float* l, int p, int ld, float* y) {
  const KernelSeat seat;
  cblas_strsv(CblasColMajor, CblasLower, CblasNoTrans, CblasNonUnit, p, l, ld, y, 1);
}

/// y ← L⁻ᵀ y.
inline void solve_lower_transposed(const double* l, int p, int ld, double* y) {
  const KernelSeat seat;
  cblas_dtrsv(CblasColMajor, CblasLower, CblasTrans, CblasNonUnit, p, l, ld, y, 1);
}
inline void solve_lower_transposed(const float* l, int p, int ld, float* y) {
  const KernelSeat seat;
  cblas_strsv(CblasColMajor, CblasLower, CblasTrans, CblasNonUnit, p, l, ld, y, 1);
}

/// out = b y with b r × p.
inline void multiply(const double* b, int r, int p, int ld, const double* y, double* out) {
  const KernelSeat seat;
  cblas_dgemv(CblasColMajor, CblasNoTrans, r, p, 1, b, ld, y, 1, 0, out, 1);
}
inline void multiply(const float* b, int r, int p, int ld, const float* y, float* out) {
  const KernelSeat seat;
  cblas_sgemv(CblasColMajor, CblasNoTrans, r, p, 1, b, ld, y, 1, 0, out, 1);
}

/// y −= bᵀ z with b r × p.
inline void subtract_transposed(const double* b, int r, int p, int ld, const double* z, double* y) {
  const KernelSeat seat;
  cblas_dgemv(CblasColMajor, CblasTrans, r, p, -1, b, ld, z, 1, 1, y, 1);
}
inline void subtract_transposed(const float* b, int r, int p, int ld, const float* z, float* y) {
  const KernelSeat seat;
  cblas_sgemv(CblasColMajor, CblasTrans, r, p, -1, b, ld, z, 1, 1, y, 1);
}

}  // namespace loosefit::solver::dense
