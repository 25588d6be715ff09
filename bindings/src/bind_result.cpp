// Results as NumPy arrays that look straight into the core's memory: read-only, and each keeps what it looks into
// alive.
#include "bind_result.h"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <memory>
#include <mutex>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "job.h"
#include "paver/display.h"
#include "paver/output.h"
#include "paver/quality.h"

namespace py = pybind11;

namespace paver::python {
namespace {

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

py::list names(const std::vector<std::string>& texts) {
  py::list list;
  for (const std::string& text : texts) list.append(to_python(text));
  return list;
}

class MeshData {
 public:
  explicit MeshData(MeshResult&& result) : result_(std::make_shared<MeshResult>(std::move(result))) {}

  const SurfaceMesh& mesh() const { return result_->mesh; }
  const MeshResult& result() const { return *result_; }
  const std::shared_ptr<MeshResult>& owner() const { return result_; }

  std::shared_ptr<const ElementQuality> quality() {
    py::gil_scoped_release free;
    std::lock_guard lock(mutex_);
    if (!quality_) quality_ = std::make_shared<ElementQuality>(element_quality(mesh()));
    return quality_;
  }

  void write(const OutputFiles& files, const py::object& poll) {
    run_job(poll, [&](Progress& progress) {
      std::lock_guard lock(mutex_);  // the time of writing goes into the report
      write_outputs(*result_, files, progress);
    });
  }

  std::string report() {
    std::lock_guard lock(mutex_);
    return report_json(*result_);
  }

 private:
  std::shared_ptr<MeshResult> result_;
  std::shared_ptr<const ElementQuality> quality_;
  std::mutex mutex_;
};

/// What Python passes: paths of mesh and report, "4.1" or "2.2", whether as text, path of the model.
using FileArguments = std::tuple<std::string, std::string, std::string, bool, std::string>;

OutputFiles output_files(const FileArguments& arguments) {
  const auto& [mesh, report, msh_version, is_ascii, input] = arguments;
  if (msh_version != "4.1" && msh_version != "2.2") {
    throw Error(ErrorCode::bad_option, "msh_version is '" + msh_version + "'; write it like 4.1 or 2.2.");
  }
  return {mesh, report, msh_version == "2.2" ? MshVersion::v2_2 : MshVersion::v4_1, is_ascii, input};
}

void bind_arrays(py::class_<MeshData>& data) {
  using Data = const MeshData&;
  data.def_property_readonly("order", [](Data d) { return d.mesh().order; });
  data.def_property_readonly("nodes", [](Data d) {
    static_assert(sizeof(Vec3) == 3 * sizeof(double));
    return view(d.owner(), reinterpret_cast<const double*>(d.mesh().nodes.data()),
                {static_cast<py::ssize_t>(d.mesh().nodes.size()), 3});
  });
  data.def_property_readonly("quads",
                             [](Data d) { return rows(d.owner(), d.mesh().quads, d.mesh().nodes_per_quad()); });
  data.def_property_readonly("triangles",
                             [](Data d) { return rows(d.owner(), d.mesh().triangles, d.mesh().nodes_per_triangle()); });
  data.def_property_readonly("lines", [](Data d) { return rows(d.owner(), d.mesh().lines, d.mesh().order + 1); });
  data.def_property_readonly("quad_faces", [](Data d) { return column(d.owner(), d.mesh().quad_face); });
  data.def_property_readonly("triangle_faces", [](Data d) { return column(d.owner(), d.mesh().triangle_face); });
  data.def_property_readonly("line_edges", [](Data d) { return column(d.owner(), d.mesh().line_edge); });
  data.def_property_readonly("node_edges", [](Data d) { return column(d.owner(), d.mesh().node_edge); });
  data.def_property_readonly("node_targets", [](Data d) { return column(d.owner(), d.mesh().node_target); });
  data.def_property_readonly("further_edges", [](Data d) {
    return view(d.owner(), reinterpret_cast<const int*>(d.mesh().further_edges.data()),
                {static_cast<py::ssize_t>(d.mesh().further_edges.size()), 2});
  });
  data.def_property_readonly("face_names", [](Data d) { return names(d.result().face_names); });
  data.def_property_readonly("edge_names", [](Data d) { return names(d.result().edge_names); });
}

py::dict tessellation(const MeshData& data, int subdivision) {
  auto cut = [&] {
    py::gil_scoped_release free;
    return std::make_shared<const Tessellation>(tessellate(data.mesh(), subdivision));
  }();
  auto count = static_cast<py::ssize_t>(cut->triangle_element.size());
  constexpr py::ssize_t integer = sizeof(int);
  py::dict arrays;
  arrays["points"] = rows(cut, cut->points, 3);
  arrays["normals"] = rows(cut, cut->normals, 3);
  arrays["triangles"] = view(cut, cut->triangles.data(), {count, 3}, {4 * integer, integer});
  arrays["triangle_indices"] = column(cut, cut->triangles);
  arrays["triangle_elements"] = column(cut, cut->triangle_element);
  py::ssize_t per_line = subdivision + 2, lines = static_cast<py::ssize_t>(cut->outline_edge.size());
  arrays["outlines"] = view(cut, cut->outlines.data(), {lines, per_line - 1}, {per_line * integer, integer});
  arrays["outline_indices"] = column(cut, cut->outlines);
  arrays["outline_edges"] = column(cut, cut->outline_edge);
  return arrays;
}

py::dict quality(MeshData& data) {
  std::shared_ptr<const ElementQuality> figures = data.quality();
  py::dict arrays;
  arrays["sj"] = column(figures, figures->sj);
  arrays["jacobian_ratio"] = column(figures, figures->jacobian_ratio);
  arrays["area"] = column(figures, figures->area);
  arrays["validity"] = column(figures, figures->validity);
  return arrays;
}

}  // namespace

void bind_result(py::module_& module) {
  py::class_<MeshData> data(module, "MeshData");
  bind_arrays(data);
  data.def("quality", quality);
  data.def("tessellate", tessellation);
  data.def("report_json", &MeshData::report, py::call_guard<py::gil_scoped_release>());
  data.def("report_table", [](const MeshData& d) { return to_python(report_table(d.result().report)); });
  data.def("check", [](const MeshData& d) {
    if (auto error = shortfall(d.result())) throw Error(*error);
  });
  data.def("write",
           [](MeshData& d, const FileArguments& files, const py::object& poll) { d.write(output_files(files), poll); });
  module.def("check_outputs", [](const FileArguments& files) { check_outputs(output_files(files)); });
}

py::object wrap_result(MeshResult&& result) { return py::cast(std::make_unique<MeshData>(std::move(result))); }

}  // namespace paver::python
