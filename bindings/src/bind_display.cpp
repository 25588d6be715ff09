// Drawing and picking: of results, and of meshes that come back as arrays from a file.
#include "bind_display.h"

#include <fmt/format.h>
#include <pybind11/stl.h>

#include <array>
#include <string>
#include <vector>

#include "arrays.h"
#include "bind_result.h"
#include "job.h"
#include "paver/display.h"
#include "paver/pick.h"

namespace paver::python {
namespace {

using VolumeArguments = std::tuple<std::string, std::string, std::vector<int>>;

using Floats = py::array_t<float, py::array::c_style | py::array::forcecast>;

/// Rows of `columns` numbers from 0 to `below`, copied out; ValueError for anything else.
std::vector<int> numbers(const char* name, const Integers& array, py::ssize_t columns, std::size_t below) {
  bool fits = columns == 1 ? array.ndim() == 1 : array.ndim() == 2 && array.shape(1) == columns;
  if (!fits) throw py::value_error(fmt::format("{} must have {} numbers per row.", name, columns));
  std::vector<int> values(array.data(), array.data() + array.size());
  for (int value : values) {
    if (value < 0 || static_cast<std::size_t>(value) >= below)
      throw py::value_error(fmt::format("{} has {}; it must be from 0 to below {}.", name, value, below));
  }
  return values;
}

void check_count(const char* name, std::size_t count, std::size_t wanted) {
  if (count != wanted) throw py::value_error(fmt::format("{} has {} rows; it must have {}.", name, count, wanted));
}

/// A mesh without its report.
class BareMesh : public Measured {
 public:
  BareMesh(int order, const Doubles& nodes, const Integers& quads, const Integers& triangles,
           const Integers& quad_faces, const Integers& triangle_faces, const Integers& lines,
           const Integers& line_edges, const Integers& points) {
    constexpr std::size_t any = 1u << 31;
    if (order < 1 || order > 9) throw py::value_error(fmt::format("order is {}; it must be from 1 to 9.", order));
    if (nodes.ndim() != 2 || nodes.shape(1) != 3) throw py::value_error("nodes must have 3 numbers per row.");
    py::gil_scoped_release free;  // what follows reads memory only; the arguments keep the arrays alive
    mesh_.order = order;
    mesh_.nodes.reserve(static_cast<std::size_t>(nodes.shape(0)));
    for (py::ssize_t i = 0; i < nodes.shape(0); ++i)
      mesh_.nodes.push_back({nodes.data(i)[0], nodes.data(i)[1], nodes.data(i)[2]});
    mesh_.quads = numbers("quads", quads, mesh_.nodes_per_quad(), mesh_.nodes.size());
    mesh_.triangles = numbers("triangles", triangles, mesh_.nodes_per_triangle(), mesh_.nodes.size());
    mesh_.quad_face = numbers("quad_faces", quad_faces, 1, any);
    mesh_.triangle_face = numbers("triangle_faces", triangle_faces, 1, any);
    mesh_.lines = numbers("lines", lines, order + 1, mesh_.nodes.size());
    mesh_.line_edge = numbers("line_edges", line_edges, 1, any);
    mesh_.points = numbers("points", points, 1, mesh_.nodes.size());
    check_count("quad_faces", mesh_.quad_face.size(), mesh_.quads.size() / mesh_.nodes_per_quad());
    check_count("triangle_faces", mesh_.triangle_face.size(), mesh_.triangles.size() / mesh_.nodes_per_triangle());
    check_count("line_edges", mesh_.line_edge.size(), mesh_.lines.size() / static_cast<std::size_t>(order + 1));
  }

  const SurfaceMesh& mesh() const override { return mesh_; }

  /// As a result with these names of faces, edges, their groups and points, and these volumes, is written, without a
  /// report. `volumes`: name, medium and sides of each.
  void write(const FileArguments& files, std::vector<std::string> face_names, std::vector<std::string> edge_names,
             std::vector<std::string> edge_groups, std::vector<std::string> point_names,
             const std::vector<VolumeArguments>& volumes, const py::object& poll) const {
    run_job(poll, [&, to = output_files(files)](Progress& progress) {
      MeshResult result;
      result.mesh = mesh_;
      result.face_names = std::move(face_names);
      result.edge_names = std::move(edge_names);
      result.edge_groups = std::move(edge_groups);
      result.point_names = std::move(point_names);
      for (const auto& [name, medium, sides] : volumes) result.volumes.push_back({name, medium, sides});
      write_outputs(result, to, progress);
    });
  }

 private:
  SurfaceMesh mesh_;
};

/// Keeps the arrays that its tree looks into.
class Picker {
 public:
  Picker(Floats points, Integers triangle_indices)
      : points_(std::move(points)), triangles_(std::move(triangle_indices)), tree_(checked()) {}

  py::list hits(const std::array<double, 3>& x, const std::array<double, 3>& along) const {
    py::list list;
    for (const PickHit& hit : tree_.hits({x[0], x[1], x[2]}, {along[0], along[1], along[2]}))
      list.append(py::make_tuple(hit.triangle, hit.along));
    return list;
  }

 private:
  PickTree checked() const {
    if (points_.ndim() != 2 || points_.shape(1) != 3) throw py::value_error("points must have 3 numbers per row.");
    if (triangles_.ndim() != 1 || triangles_.size() % 4 != 0)
      throw py::value_error("triangle_indices must have three points and -1 for each triangle.");
    py::gil_scoped_release free;
    for (py::ssize_t i = 0; i < triangles_.size(); ++i) {
      int point = triangles_.data()[i];
      if (i % 4 != 3 && (point < 0 || point >= points_.shape(0)))
        throw py::value_error(fmt::format("triangle_indices has {}; there are {} points.", point, points_.shape(0)));
    }
    return PickTree({points_.data(), static_cast<std::size_t>(points_.size())},
                    {triangles_.data(), static_cast<std::size_t>(triangles_.size())});
  }

  Floats points_;
  Integers triangles_;
  PickTree tree_;
};

}  // namespace

py::dict Measured::tessellate(int subdivision, bool apart) const {
  auto cut = [&] {
    py::gil_scoped_release free;
    return std::make_shared<const Tessellation>(apart ? tessellate_apart(mesh(), subdivision)
                                                      : paver::tessellate(mesh(), subdivision));
  }();
  auto count = static_cast<py::ssize_t>(cut->triangle_element.size());
  constexpr py::ssize_t integer = sizeof(int);
  py::ssize_t per_line = subdivision + 2, lines = static_cast<py::ssize_t>(cut->outline_edge.size());
  return py::dict("points"_a = rows(cut, cut->points, 3), "normals"_a = rows(cut, cut->normals, 3),
                  "triangles"_a = view(cut, cut->triangles.data(), {count, 3}, {4 * integer, integer}),
                  "triangle_indices"_a = column(cut, cut->triangles),
                  "triangle_elements"_a = column(cut, cut->triangle_element),
                  "outlines"_a = view(cut, cut->outlines.data(), {lines, per_line - 1}, {per_line * integer, integer}),
                  "outline_indices"_a = column(cut, cut->outlines), "outline_edges"_a = column(cut, cut->outline_edge),
                  "outline_elements"_a = column(cut, cut->outline_elements));
}

py::dict Measured::quality() {
  {
    py::gil_scoped_release free;
    std::lock_guard lock(mutex_);
    if (!quality_) quality_ = std::make_shared<ElementQuality>(element_quality(mesh()));
  }
  return py::dict("sj"_a = column(quality_, quality_->sj),
                  "jacobian_ratio"_a = column(quality_, quality_->jacobian_ratio),
                  "area"_a = column(quality_, quality_->area), "validity"_a = column(quality_, quality_->validity));
}

void bind_display(py::module_& module) {
  py::class_<Measured>(module, "Measured").def("quality", &Measured::quality).def("tessellate", &Measured::tessellate);
  py::class_<BareMesh, Measured>(module, "BareMesh")
      .def(py::init<int, const Doubles&, const Integers&, const Integers&, const Integers&, const Integers&,
                    const Integers&, const Integers&, const Integers&>())
      .def("write", &BareMesh::write);
  py::class_<Picker>(module, "Picker").def(py::init<Floats, Integers>()).def("hits", &Picker::hits);
}

}  // namespace paver::python
