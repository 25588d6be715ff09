// Whole runs and their stages on the example models, on one core, beside the floor: evaluating each final node once on
// its surface. Counters: elements per second, peak memory, mean SJ.
//   whole/MODEL/N     mesh_file()
//   stage/NAME/MODEL/N  the same run, time of one stage as the report has it
//   floor/MODEL/N     as many surface evaluations as the mesh has nodes
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "brep/reading/read_shape.h"
#include "paver/mesher.h"
#include "support/folders.h"
#include "topology/build_model.h"

namespace {

using paver::Vec2;
using paver::Vec3;

struct Case {
  std::string name;
  double area;  ///< mm^2, to choose the target length
  long elements;
  std::string path() const {
    const std::filesystem::path step = paver::test::examples_folder() / (name + ".step");
    return std::filesystem::exists(step) ? step : paver::test::examples_folder() / (name + ".brep");
  }
  std::string label() const { return name + "/" + std::to_string(elements); }
  paver::Options options() const {
    paver::Options options;
    options.size = std::sqrt(area / static_cast<double>(elements));
    options.threads = 1;
    return options;
  }
};

const std::vector<Case> cases{
    {"plate_circular_hole", 34973, 1000},
    {"plate_circular_hole", 34973, 20000},
    {"plate_circular_hole", 34973, 500000},
    {"sphere", 125664, 20000},
    {"torus", 138174, 20000},
    {"box_cylinder", 44625, 20000},
    {"wavy_patch", 46900, 20000},
    {"wing", 119854, 20000},
    {"conesphere_gap", 58592, 530000},
    {"wind_generator", 215630200, 441409},
};
const std::vector<std::string> stages{"read",   "topology", "sizing", "boundary", "regions",
                                      "paving", "repair",   "join",   "curving",  "quality"};

/// Makes the peak memory of the process start anew, where the system allows it.
void reset_peak_memory() {
  if (std::FILE* file = std::fopen("/proc/self/clear_refs", "w")) {
    std::fputs("5", file);
    std::fclose(file);
  }
}

double element_count(const paver::MeshResult& result) {
  return static_cast<double>(result.mesh.quad_count() + result.mesh.triangle_count());
}

void bench_whole(benchmark::State& state, const Case& c) {
  paver::MeshResult result;
  reset_peak_memory();
  for (auto _ : state) {
    paver::Progress progress;
    result = paver::mesh_file(c.path(), c.options(), progress);
  }
  double n = element_count(result);
  state.counters["elements"] = n;
  state.counters["elements/s"] = benchmark::Counter(n, benchmark::Counter::kIsIterationInvariantRate);
  state.counters["peak_MiB"] = result.report.peak_memory_mib;
  state.counters["mean_SJ"] = result.report.quality.sj_all.mean;
}

/// One run per case, kept for its stages and its floor.
const paver::MeshResult& run_once(const Case& c) {
  static std::map<std::string, paver::MeshResult> done;
  auto found = done.find(c.label());
  if (found == done.end()) {
    paver::Progress progress;
    found = done.emplace(c.label(), paver::mesh_file(c.path(), c.options(), progress)).first;
  }
  return found->second;
}

void bench_stage(benchmark::State& state, const Case& c, const std::string& stage) {
  const paver::MeshResult& result = run_once(c);
  double seconds = 0;
  for (const auto& [name, time] : result.report.stage_seconds) seconds += name == stage ? time : 0;
  for (auto _ : state) state.SetIterationTime(seconds);
  if (seconds > 0) state.counters["elements/s"] = element_count(result) / seconds;
}

/// Box of a face in (u, v), from points on its loops.
std::pair<Vec2, Vec2> parameter_box(const paver::Model& model, const paver::Face& face) {
  Vec2 lo{1e300, 1e300}, hi{-1e300, -1e300};
  for (const paver::Loop& loop : face.loops) {
    for (const paver::Coedge& coedge : loop.coedges) {
      const paver::Edge& edge = model.edges[static_cast<std::size_t>(coedge.edge)];
      for (int i = 0; i <= 20; ++i) {
        Vec2 uv = coedge.pcurve->uv(edge.t0 + (edge.t1 - edge.t0) * i / 20);
        lo = {std::min(lo.x, uv.x), std::min(lo.y, uv.y)};
        hi = {std::max(hi.x, uv.x), std::max(hi.y, uv.y)};
      }
    }
  }
  return {lo, hi};
}

/// Evaluates points and first derivatives at `count` places, row after row as a mesh lies on the face.
double sweep(const paver::Surface& surface, Vec2 lo, Vec2 hi, long count) {
  long side = std::max(1L, std::lround(std::sqrt(static_cast<double>(count))));
  double sum = 0;
  for (long k = 0; k < count; ++k) {
    double s = (static_cast<double>(k % side) + 0.5) / static_cast<double>(side);
    double t = (static_cast<double>(k / side) + 0.5) / static_cast<double>(count / side + 1);
    const auto [x, xu, xv] = surface.slope({lo.x + s * (hi.x - lo.x), lo.y + t * (hi.y - lo.y)});
    sum += x.x + xu.y + xv.z;
  }
  return sum;
}

void bench_floor(benchmark::State& state, const Case& c) {
  const paver::MeshResult& result = run_once(c);
  paver::Progress progress;
  paver::ModelReport report;
  auto shape = paver::read_shape(c.path(), report, progress);
  paver::SingleRank alone;
  paver::SharedTasks tasks(1, progress, alone);
  paver::Model model = paver::build_model(*shape, c.options(), report, progress, tasks);
  double per_area = static_cast<double>(result.mesh.nodes.size()) / c.area;
  for (auto _ : state) {
    for (const paver::Face& face : model.faces) {
      auto [lo, hi] = parameter_box(model, face);
      benchmark::DoNotOptimize(sweep(*face.surface, lo, hi, std::lround(per_area * face.area)));
    }
  }
  state.counters["elements/s"] =
      benchmark::Counter(element_count(result), benchmark::Counter::kIsIterationInvariantRate);
}

const bool registered = [] {
  for (const Case& c : cases) {
    benchmark::RegisterBenchmark(("whole/" + c.label()).c_str(), bench_whole, c)->Unit(benchmark::kMillisecond);
    for (const std::string& stage : stages) {
      benchmark::RegisterBenchmark(("stage/" + stage + "/" + c.label()).c_str(), bench_stage, c, stage)
          ->UseManualTime()
          ->Iterations(1)
          ->Unit(benchmark::kMillisecond);
    }
    benchmark::RegisterBenchmark(("floor/" + c.label()).c_str(), bench_floor, c)->Unit(benchmark::kMillisecond);
  }
  return true;
}();

}  // namespace
