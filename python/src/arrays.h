#pragma once
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <memory>
#include <utility>
#include <vector>

#include "loosefit/base/types.h"

// NumPy arrays that show memory of ours instead of copying it.
namespace loosefit::python {

namespace py = pybind11;

/// A read-only array over `data`, which `owner` keeps alive as long as the array, or any view of
/// it, lives.
template <class T>
py::array shown(const T* data, std::vector<py::ssize_t> shape, std::shared_ptr<const void> owner) {
  using Owner = std::shared_ptr<const void>;
  auto kept = std::make_unique<Owner>(std::move(owner));
  const py::capsule base(kept.get(), [](void* held) { delete static_cast<Owner*>(held); });
  kept.release();
  py::array array(py::dtype::of<T>(), std::move(shape), data, base);
  py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return array;
}

/// (n,) of numbers.
template <class T>
py::array shown(const std::vector<T>& values, std::shared_ptr<const void> owner) {
  return shown(values.data(), {static_cast<py::ssize_t>(values.size())}, std::move(owner));
}

/// (n, 3) of points, float64.
inline py::array shown(const std::vector<Vec3>& points, std::shared_ptr<const void> owner) {
  static_assert(sizeof(Vec3) == 3 * sizeof(double));
  return shown(reinterpret_cast<const double*>(points.data()),
               {static_cast<py::ssize_t>(points.size()), 3}, std::move(owner));
}

/// (n, 2) of points in a pattern, float64.
inline py::array shown(const std::vector<Vec2>& points, std::shared_ptr<const void> owner) {
  static_assert(sizeof(Vec2) == 2 * sizeof(double));
  return shown(reinterpret_cast<const double*>(points.data()),
               {static_cast<py::ssize_t>(points.size()), 2}, std::move(owner));
}

/// (m, 3) of corner indices, int32.
inline py::array shown(const std::vector<Triangle>& triangles, std::shared_ptr<const void> owner) {
  static_assert(sizeof(Triangle) == 3 * sizeof(int));
  return shown(reinterpret_cast<const int*>(triangles.data()),
               {static_cast<py::ssize_t>(triangles.size()), 3}, std::move(owner));
}

/// An array of its own for values that were just made; nothing is copied.
template <class T>
py::array owned(std::vector<T> values) {
  auto kept = std::make_shared<const std::vector<T>>(std::move(values));
  return shown(*kept, kept);
}

}  // namespace loosefit::python
