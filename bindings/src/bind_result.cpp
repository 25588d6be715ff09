// Results as NumPy arrays that look straight into the core's memory: read-only, and each keeps what it looks into
// alive.
#include "bind_result.h"

#include <pybind11/stl.h>

#include <memory>
#include <mutex>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "arrays.h"
#include "bind_display.h"
#include "job.h"
#include "paver/output.h"

namespace paver::python {
namespace {

py::list names(const std::vector<std::string>& texts) {
  py::list list;
  for (const std::string& text : texts) list.append(to_python(text));
  return list;
}

class MeshData : public Measured {
 public:
  explicit MeshData(MeshResult&& result) : result_(std::make_shared<MeshResult>(std::move(result))) {}

  const SurfaceMesh& mesh() const override { return result_->mesh; }
  const MeshResult& result() const { return *result_; }
  const std::shared_ptr<MeshResult>& owner() const { return result_; }

  void write(const FileArguments& files, const py::object& poll) {
    run_job(poll, [&, to = output_files(files)](Progress& progress) {
      std::lock_guard lock(mutex_);  // the time of writing goes into the report
      write_outputs(*result_, to, progress);
    });
  }

  std::string report() {
    std::lock_guard lock(mutex_);
    return report_json(*result_);
  }

 private:
  std::shared_ptr<MeshResult> result_;
  std::mutex mutex_;
};

void bind_arrays(py::class_<MeshData, Measured>& data) {
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
  data.def_property_readonly("points", [](Data d) { return column(d.owner(), d.mesh().points); });
  data.def_property_readonly("point_names", [](Data d) { return names(d.result().point_names); });
  data.def_property_readonly("face_names", [](Data d) { return names(d.result().face_names); });
  data.def_property_readonly("face_groups", [](Data d) { return names(d.result().face_groups); });
  data.def_property_readonly("volumes", [](Data d) {
    py::list list;
    for (const Volume& volume : d.result().volumes)
      list.append(py::make_tuple(to_python(volume.name), to_python(volume.medium), volume.sides));
    return list;
  });
  data.def_property_readonly("edge_groups", [](Data d) { return names(d.result().edge_groups); });
  data.def_property_readonly("edge_names", [](Data d) { return names(d.result().edge_names); });
}

}  // namespace

OutputFiles output_files(const FileArguments& arguments) {
  const auto& [mesh, report, version_text, is_ascii, input, repaired, repaired_text] = arguments;
  const std::optional<MshVersion> version = msh_version(version_text);
  if (!version) throw Error(ErrorCode::bad_option, "msh_version is '" + version_text + "'; write it like 4.1 or 2.2.");
  return {mesh, report, *version, is_ascii, input, repaired, repaired_text};
}

void bind_result(py::module_& module) {
  py::class_<MeshData, Measured> data(module, "MeshData");
  bind_arrays(data);
  data.def("report_json", &MeshData::report, py::call_guard<py::gil_scoped_release>());
  data.def("report_table", [](const MeshData& d) { return to_python(report_table(d.result().report)); });
  data.def("check", [](const MeshData& d) {
    if (auto error = shortfall(d.result())) throw Error(*error);
  });
  data.def("write", &MeshData::write);
  module.def("check_outputs", [](const FileArguments& files) { check_outputs(output_files(files)); });
}

py::object wrap_result(MeshResult&& result) { return py::cast(std::make_unique<MeshData>(std::move(result))); }

}  // namespace paver::python
