// NumPy arrays: as arguments, and as what looks into memory of the core.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <memory>
#include <utility>
#include <vector>

namespace paver::python {

namespace py = pybind11;

using namespace py::literals;
using Integers = py::array_t<int, py::array::c_style | py::array::forcecast>;
using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Shape = std::vector<py::ssize_t>;

/// `data`, laid out as `shape` (and `strides` in bytes, else packed), is kept alive by `owner`.
template <class T, class Owner>
py::array view(const std::shared_ptr<Owner>& owner, const T* data, Shape shape, Shape strides = {}) {
  auto* keep = new std::shared_ptr<const void>(owner);
  py::capsule base(keep, [](void* pointer) { delete static_cast<std::shared_ptr<const void>*>(pointer); });
  py::array array = strides.empty() ? py::array(py::dtype::of<T>(), std::move(shape), data, base)
                                    : py::array(py::dtype::of<T>(), std::move(shape), std::move(strides), data, base);
  array.attr("setflags")(py::arg("write") = false);
  return array;
}

template <class T, class Owner>
py::array rows(const std::shared_ptr<Owner>& owner, const std::vector<T>& values, int columns) {
  return view(owner, values.data(), {static_cast<py::ssize_t>(values.size()) / columns, columns});
}

template <class T, class Owner>
py::array column(const std::shared_ptr<Owner>& owner, const std::vector<T>& values) {
  return view(owner, values.data(), {static_cast<py::ssize_t>(values.size())});
}

}  // namespace paver::python
