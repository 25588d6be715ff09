// The Python module: arrays in, arrays out.
#include <pybind11/complex.h>
#include <pybind11/eigen.h>
#include <pybind11/pybind11.h>

#include "scattering.h"

namespace py = pybind11;
using namespace paver::validation;

PYBIND11_MODULE(_scattering, module) {
  module.doc() = "Method of Moments for perfectly conducting surfaces on curved quads and triangles.";
  py::class_<MeshedSurface>(module, "Surface", "A mesh with a function for each pair of elements at a side.")
      .def(py::init<const Eigen::MatrixX3d&, const Eigen::MatrixXi&, const Eigen::MatrixXi&>(), py::arg("nodes"),
           py::arg("quads"), py::arg("triangles"))
      .def_property_readonly("unknowns", &MeshedSurface::functions)
      .def_property_readonly("is_closed", &MeshedSurface::is_closed);
  py::class_<Scatterer>(module, "Scatterer", "The equation of a surface, filled and factorised.")
      .def(py::init(
               [](const MeshedSurface& surface, double wave_number, double electric_share, int threads, int points) {
                 py::gil_scoped_release released;
                 return std::make_unique<Scatterer>(surface, Settings{wave_number, electric_share, threads, points});
               }),
           py::arg("surface"), py::arg("wave_number"), py::arg("electric_share") = 1.0, py::arg("threads") = 0,
           py::arg("singular_points") = 4, py::keep_alive<1, 2>())
      .def("monostatic", &Scatterer::monostatic, py::arg("angles"), py::call_guard<py::gil_scoped_release>(),
           "Amplitudes (n, 2), theta-theta and phi-phi, of waves from `angles` (n, 2): theta and phi, radians.")
      .def("bistatic", &Scatterer::bistatic, py::arg("incident"), py::arg("polarisation"), py::arg("angles"),
           py::call_guard<py::gil_scoped_release>(),
           "Amplitudes (n, 2) along theta and phi towards `angles` of one wave from `incident`.")
      .def_property_readonly("fill_seconds", &Scatterer::fill_seconds)
      .def_property_readonly("solve_seconds", &Scatterer::solve_seconds);
}
