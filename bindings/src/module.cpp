// The compiled part of the Python package: models, runs, errors, the table of options. bindings/paver wraps it.
#include <pybind11/stl.h>

#include <chrono>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "arrays.h"
#include "bind_display.h"
#include "bind_result.h"
#include "job.h"
#include "paver/launch.h"
#include "paver/mesher.h"
#include "paver/option_table.h"
#include "paver/solver.h"
#include "paver/stage_table.h"

namespace paver::python {
namespace {

/// Its end is the version. It stands in the file with this beginning for _load.py, which reads it there before it
/// loads.
constexpr char marked_version[] = "Paver's compiled module, version " PAVER_VERSION;

/// A file or its content, read when it is first needed, once.
class Source {
 public:
  static std::unique_ptr<Source> of_file(const std::string& path, const std::string& name) {
    auto source = std::make_unique<Source>();
    source->path_ = path;
    source->name_ = name;
    return source;
  }
  /// `labels`: names for the faces, as read_bytes() takes them.
  static std::unique_ptr<Source> of_bytes(const py::buffer& content, const std::string& name,
                                          const std::vector<std::string>& labels) {
    auto source = std::make_unique<Source>();
    py::buffer_info info = content.request();
    const char* bytes = static_cast<const char*>(info.ptr);
    source->bytes_.emplace(bytes, bytes + info.size * info.itemsize);
    source->name_ = name;
    source->labels_ = labels;
    return source;
  }

  CadModel model(Progress& progress) {
    std::unique_lock lock(mutex_, std::defer_lock);
    while (!lock.try_lock_for(std::chrono::milliseconds(20))) progress.check();
    if (!model_) model_ = bytes_ ? read_bytes(*bytes_, name_, progress, labels_) : read_file(path_, progress, name_);
    return *model_;
  }

  /// Meshed by other processes, which read it themselves.
  MeshResult mesh_in_ranks(const std::vector<GivenOption>& given, int ranks, Progress& progress) const {
    Job job;
    job.input = path_;
    job.name = name_;
    job.labels = labels_;
    job.options = given;
    job.returns_mesh = true;
    return paver::mesh_in_ranks(job, ranks, progress, bytes_ ? std::span<const char>(*bytes_) : std::span<const char>())
        .result;
  }

 private:
  std::string path_, name_;
  std::vector<std::string> labels_;
  std::optional<std::vector<char>> bytes_;
  std::timed_mutex mutex_;
  std::optional<CadModel> model_;
};

py::object mesh(Source& source, const std::vector<GivenOption>& given, const py::object& poll) {
  Options options = read_options(given);
  check(options);
  MeshResult result;
  run_job(poll, [&](Progress& progress) {
    result = options.ranks > 0 ? source.mesh_in_ranks(given, options.ranks, progress)
                               : mesh_model(source.model(progress), options, progress);
  });
  return wrap_result(std::move(result));
}

template <class T>
py::array_t<T> copied(const std::vector<T>& values) {
  return py::array_t<T>(static_cast<py::ssize_t>(values.size()), values.data());
}

py::dict predict(Source& source, const std::vector<GivenOption>& given, const py::object& poll) {
  Options options = read_options(given);
  check(options);
  Prediction found;
  run_job(poll, [&](Progress& progress) { found = paver::predict(source.model(progress), options, progress); });
  py::list merges, contacts;
  for (const auto& [kind, name, into, size, where] : found.merges)
    merges.append(py::dict("kind"_a = merge_name(kind), "name"_a = to_python(name), "into"_a = to_python(into),
                           "size"_a = size, "where"_a = py::make_tuple(where.x, where.y, where.z)));
  for (const auto& [parts, kind, faces, size, gap] : found.contacts)
    contacts.append(py::dict("parts"_a = py::make_tuple(to_python(parts[0]), to_python(parts[1])),
                             "kind"_a = contact_name(kind), "size"_a = size, "gap"_a = gap));
  return py::dict("target_length"_a = found.target_length, "elements"_a = found.elements,
                  "memory_mib"_a = found.memory_mib, "face_elements"_a = copied(found.face_elements),
                  "merges"_a = merges, "contacts"_a = contacts);
}

py::array_t<double> target_lengths(Source& source, const std::vector<GivenOption>& given, const Integers& faces,
                                   const Doubles& uv, const Doubles& points, const py::object& poll) {
  Options options = read_options(given);
  check(options);
  const py::ssize_t count = faces.size();
  if (faces.ndim() != 1 || uv.ndim() != 2 || points.ndim() != 2 || uv.shape(0) != count || points.shape(0) != count ||
      uv.shape(1) != 2 || points.shape(1) != 3)
    throw py::value_error("faces, uv and points must be (n,), (n, 2) and (n, 3).");
  std::vector<FacePoint> places(static_cast<std::size_t>(count));
  for (py::ssize_t i = 0; i < count; ++i)
    places[static_cast<std::size_t>(i)] = {
        faces.at(i), {uv.at(i, 0), uv.at(i, 1)}, {points.at(i, 0), points.at(i, 1), points.at(i, 2)}};
  std::vector<double> found;
  run_job(poll, [&](Progress& progress) {
    found = paver::target_lengths(source.model(progress), options, places, progress);
  });
  return copied(found);
}

/// Lengths in mm; wavelength, least_segment: 0: not known.
std::vector<std::string> hints(double shortest, double longest, double wavelength, long junctions,
                               double least_segment) {
  SolverFigures figures;
  figures.shortest_edge = shortest, figures.longest_edge = longest, figures.junction_edges = junctions;
  if (wavelength > 0) figures.wavelength = wavelength;
  if (least_segment > 0) figures.least_segment = least_segment;
  return solver_hints(figures);
}

py::bytes repaired(Source& source, const std::vector<GivenOption>& given, const py::object& poll) {
  Options options = read_options(given);
  check(options);
  std::string text;
  run_job(poll, [&](Progress& progress) { text = repaired_model(source.model(progress), options, progress); });
  return text;
}

py::list parts(Source& source, const py::object& poll) {
  std::vector<ModelPart> found;
  run_job(poll, [&](Progress& progress) { found = model_parts(source.model(progress)); });
  py::list result;
  for (const ModelPart& part : found)
    result.append(py::make_tuple(copied(part.faces), copied(part.edges), copied(part.vertices), copied(part.solids)));
  return result;
}

py::list options() {
  py::list list;
  for (const OptionInfo& info : option_table())
    list.append(py::dict("name"_a = info.name, "kind"_a = kind_name(info.kind), "letter"_a = info.letter,
                         "help"_a = info.help, "default"_a = info.default_text, "needs"_a = info.needs,
                         "excludes"_a = info.excludes, "may_be_zero"_a = info.may_be_zero, "choices"_a = info.choices));
  return list;
}

py::dict exit_codes() {
  py::dict codes;
  for (int number = 0; number <= static_cast<int>(ErrorCode::internal); ++number) {
    ErrorCode code = static_cast<ErrorCode>(number);
    codes[code_name(code)] = exit_code(code);
  }
  return codes;
}

py::list stages() {
  py::list list;
  for (const StageInfo& info : stage_table()) list.append(py::make_tuple(info.name, info.text, info.share));
  return list;
}

/// paver._errors makes the exception: its classes are Python's.
void raise_in_python(const Error& error) {
  const Where& where = error.where();
  py::object point = py::none();
  if (where.point) point = py::make_tuple(where.point->x, where.point->y, where.point->z);
  py::object exception = py::module_::import("paver._errors")
                             .attr("from_core")(code_name(error.code()), to_python(error.what()),
                                                to_python(error.remedy()), where.stage, where.face, where.edge, point);
  PyErr_SetObject(reinterpret_cast<PyObject*>(Py_TYPE(exception.ptr())), exception.ptr());
}

}  // namespace
}  // namespace paver::python

/// pybind11 before 2.12 has the memory layout of NumPy 1 alone.
constexpr bool knows_numpy_2 = PYBIND11_VERSION_HEX >= 0x020C0000;

PYBIND11_MODULE(_paver, module) {
  using namespace paver::python;
  py::register_exception_translator([](std::exception_ptr pointer) {
    try {
      if (pointer) std::rethrow_exception(pointer);
    } catch (const paver::Error& error) {
      raise_in_python(error);
    }
  });
  module.attr("version") = std::string(marked_version).substr(sizeof marked_version - sizeof PAVER_VERSION);
  module.attr("knows_numpy_2") = knows_numpy_2;
  py::class_<Source>(module, "Source")
      .def_static("of_file", &Source::of_file)
      .def_static("of_bytes", &Source::of_bytes);
  bind_display(module);
  bind_result(module);
  module.def("mesh", mesh);
  module.def("predict", predict);
  module.def("target_lengths", target_lengths);
  module.def("solver_hints", hints);
  module.def("repaired", repaired);
  module.def("parts", parts);
  module.def("options", options);
  module.def("exit_codes", exit_codes);
  module.def("stages", stages);
  module.def("cancel_all_jobs", cancel_all_jobs);
}
