// The whole job: one call per stage, every arrow one value.
// read -> topology -> sizing -> boundary nodes -> regions -> paving -> join -> curving -> quality
#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <map>
#include <mutex>
#include <numeric>

#include "boundary/edge_nodes.h"
#include "boundary/prediction.h"
#include "brep/occt_impl.h"
#include "curving/place_nodes.h"
#include "curving/repair.h"
#include "join/join.h"
#include "mesh/flat_elements.h"
#include "multilevel/multilevel.h"
#include "parallel/tasks.h"
#include "paver/mesher.h"
#include "paving/pave_region.h"
#include "quality/jacobian.h"
#include "quality/report.h"
#include "regions/build_regions.h"
#include "topology/build_model.h"

namespace paver {
namespace {

constexpr int most_refinements = 12;  // rounds of dividing edges whose divisions cross
constexpr int most_splits = 3;        // rounds of splitting quads that stay invalid
constexpr const char* kernel_failure = "The CAD kernel failed at this model; report it with the model";

class Run {
 public:
  Run(const Options& options, Progress& progress) : options_(options), progress_(progress) {}

  MeshResult mesh(const CadModel& model) {
    start();
    build(model);
    divide();
    pave();
    assemble();
    measure();
    name_edges();
    return std::move(result_);
  }

  Prediction predict(const CadModel& model) {
    start();
    build(model);
    std::vector<FaceLayout> layouts;
    std::vector<int> counts = count_intervals(layouts);
    std::vector<double> elements = predict_elements(model_, size_, counts, options_.elements);
    Prediction prediction;
    prediction.target_length = result_.report.target_length;
    prediction.face_elements.assign(static_cast<std::size_t>(result_.report.model.faces), 0);
    for (std::size_t i = 0; i < model_.faces.size(); ++i) {
      prediction.face_elements[static_cast<std::size_t>(model_.faces[i].origin)] += elements[i];
      prediction.elements += elements[i];
    }
    prediction.memory_mib = predict_memory_mib(prediction.elements, options_);
    return prediction;
  }

 private:
  using Clock = std::chrono::steady_clock;

  void begin(Stage stage, long total = 1) {
    end_stage();
    progress_.begin(stage, total);
    stage_ = stage;
    started_ = Clock::now();
  }

  void end_stage() {
    if (stage_ == Stage::done) return;
    double seconds = std::chrono::duration<double>(Clock::now() - started_).count();
    auto& list = result_.report.stage_seconds;
    auto known = std::find_if(list.begin(), list.end(), [&](const auto& s) { return s.first == stage_name(stage_); });
    if (known != list.end()) {
      known->second += seconds;
    } else {
      list.push_back({stage_name(stage_), seconds});
    }
    stage_ = Stage::done;
  }

  void start() {
    check(options_);
    RunReport& report = result_.report;
    report.target_length = target_length(options_);
    report.order = options_.order;
    report.elements = options_.elements;
    report.threads = thread_count(options_.threads);
  }

  void build(const CadModel& model) {
    result_.report.stage_seconds.push_back({stage_name(Stage::read), model.read_seconds});
    begin(Stage::topology);
    model_ = build_model(*model.shape, options_, result_.report.target_length, model.report, progress_);
    result_.report.model = model_.report;
    result_.report.notes = model_.notes;
    for (const Face& face : model_.faces) {
      FaceReport report;
      report.name = face.name;
      report.cad_area = face.area;
      if (!face.has_area) report.status = FaceStatus::no_area;
      if (face.has_area && !face.fault.empty()) {
        report.status = FaceStatus::failed;
        report.stage = "topology";
        report.reason = face.fault;
      }
      result_.report.faces.push_back(report);
      result_.face_names.push_back(face.label.empty() ? face.name : face.label);
    }
  }

  // Sizing, and the number of intervals of every edge.
  std::vector<int> count_intervals(std::vector<FaceLayout>& layouts) {
    begin(Stage::sizing);
    size_ = build_size_field(model_, options_, progress_);
    for (const std::string& note : size_.local->notes()) result_.report.notes.push_back(note);
    begin(Stage::boundary);
    layouts = plan_layouts(model_, size_, progress_);
    std::vector<int> counts = choose_counts(model_, size_, progress_, options_.elements == Elements::all_quad);
    settle_counts(model_, layouts, counts);
    return counts;
  }

  // Boundary nodes and regions; edges whose divisions cross in a chart are divided further until they do not.
  void divide() {
    std::vector<FaceLayout> layouts;
    std::vector<int> counts = count_intervals(layouts);
    for (int round = 0;; ++round) {
      nodes_ = divide_edges(model_, size_, counts, progress_);
      regions_ = build_regions(model_, size_, layouts, nodes_);
      if (round == most_refinements || !refine_crossings(counts)) break;
    }
    begin(Stage::regions);
  }

  // Doubles the counts of crossing edges, keeping their parity. Whether anything crossed.
  bool refine_crossings(std::vector<int>& counts) {
    std::vector<std::array<int, 2>> crossing(regions_.size(), {-1, -1});
    run_tasks(options_.threads, costs(), [&](int i) {
      progress_.check();
      if (auto edges = find_crossing(regions_[i])) crossing[i] = *edges;
    });
    std::vector<bool> is_refined(counts.size(), false);
    for (const auto& pair : crossing)
      for (int e : pair)
        if (e >= 0 && counts[e] < 100000) is_refined[e] = true;
    for (std::size_t e = 0; e < counts.size(); ++e)
      if (is_refined[e]) counts[e] = 2 * counts[e] + counts[e] % 2;
    return std::find(is_refined.begin(), is_refined.end(), true) != is_refined.end();
  }

  std::vector<double> costs() const {
    std::vector<double> cost;
    for (const Region& region : regions_) {
      double area = model_.faces[region.face].area;
      cost.push_back(area / (region.h * region.h));
    }
    return cost;
  }

  void fail(int face, const Error& error) {
    std::lock_guard lock(mutex_);
    FaceReport& report = result_.report.faces[face];
    report.status = FaceStatus::failed;
    report.stage = error.where().stage;
    report.reason = error.what();
    report.where = error.where().point;
  }

  void pave() {
    begin(Stage::paving, static_cast<long>(regions_.size()));
    paved_.resize(regions_.size());
    run_tasks(options_.threads, costs(), [&](int i) {
      int face = regions_[i].face;
      try {
        paved_[i] = pave_by_levels(regions_[i], options_.multilevel, progress_, options_.elements);
      } catch (const Error& error) {
        if (error.code() == ErrorCode::cancelled) throw;
        fail(face, error);
      } catch (const Standard_Failure& failure) {
        fail(face,
             Error(ErrorCode::face_failed,
                   "the CAD kernel cannot evaluate it (" + failure_text(failure) + "); repair it in the CAD program",
                   {stage_name(Stage::paving), face, -1, {}}));
      }
      progress_.advance();
    });
    for (std::size_t i = 0; i < regions_.size(); ++i)
      result_.report.faces[regions_[i].face].closed_by_triangulation += paved_[i].counts.closed_by_triangulation;
  }

  // Joining and curving. Faces with invalid elements are paved with other rows, then mended element by element; where
  // that is not enough they are paved finer and mended again.
  void assemble() {
    std::vector<long> invalid = join_and_curve();
    int next = 1;
    for (int last : {1, further_attempts}) {
      for (; next <= last && has_any(invalid); ++next) invalid = pave_invalid(std::move(invalid), next);
      invalid = split_invalid(std::move(invalid));
      if (options_.order > 1) straighten_last(invalid);
      if (!has_any(invalid)) break;
    }
    note_invalid(invalid);
  }

  static bool has_any(const std::vector<long>& invalid) {
    return std::any_of(invalid.begin(), invalid.end(), [](long n) { return n > 0; });
  }

  // Paves the faces with invalid elements in another way and keeps it where it leaves fewer.
  std::vector<long> pave_invalid(std::vector<long> invalid, int attempt) {
    std::vector<PavedRegion> before = pave_again(invalid, attempt);
    std::vector<long> now = join_and_curve();
    bool is_reverted = false;
    for (std::size_t i = 0; i < regions_.size(); ++i) {
      int face = regions_[i].face;
      if (invalid[face] == 0 || now[face] < invalid[face]) continue;
      paved_[i] = std::move(before[i]);
      is_reverted = true;
    }
    return is_reverted ? join_and_curve() : std::move(now);
  }

  // Invalid quads become two triangles each, as long as that leaves fewer invalid elements.
  std::vector<long> split_invalid(std::vector<long> invalid) {
    for (int round = 0; round < most_splits && !invalid_quads_.empty(); ++round) {
      std::vector<PavedRegion> before = paved_;
      for (int q : invalid_quads_) {
        auto [part, element] = joined_.quad_source[q];
        split_quad(paved_[part].mesh, element);
      }
      std::vector<long> now = join_and_curve();
      bool is_better =
          std::accumulate(now.begin(), now.end(), 0L) < std::accumulate(invalid.begin(), invalid.end(), 0L);
      if (!is_better) {
        paved_ = std::move(before);
        return join_and_curve();
      }
      invalid = std::move(now);
    }
    return invalid;
  }

  void straighten_last(std::vector<long>& invalid) {
    RepairResult last = straighten_at_edges(result_.mesh, is_valid, invalid_quads_, invalid_triangles_);
    if (last.recentred + last.straightened == 0) return;
    straightened_ += last.recentred + last.straightened;
    result_.report.notes.push_back(fmt::format(
        "To keep elements valid sides were straightened along B-rep edges, up to {:.3g} mm off.", last.off_edge));
    std::fill(invalid.begin(), invalid.end(), 0);
    for (int q : last.invalid_quads) ++invalid[result_.mesh.quad_face[q]];
    for (int t : last.invalid_triangles) ++invalid[result_.mesh.triangle_face[t]];
  }

  // Regions of faces with invalid elements, paved another way; returns what they were.
  std::vector<PavedRegion> pave_again(const std::vector<long>& invalid, int attempt) {
    std::vector<PavedRegion> before(regions_.size());
    run_tasks(options_.threads, costs(), [&](int i) {
      if (invalid[regions_[i].face] == 0) return;
      before[i] = std::move(paved_[i]);
      paved_[i] = pave_region_again(regions_[i], attempt, progress_, options_.elements);
    });
    return before;
  }

  std::vector<long> join_and_curve() {
    begin(Stage::join);
    join();
    begin(Stage::curving);
    return curve();
  }

  void join() {
    while (true) {
      std::vector<JoinPart> parts;
      for (std::size_t i = 0; i < regions_.size(); ++i) {
        int face = regions_[i].face;
        bool is_meshed = result_.report.faces[face].status == FaceStatus::meshed;
        parts.push_back({face, is_meshed ? &paved_[i].mesh : nullptr});
      }
      try {
        joined_ = join_regions(model_, nodes_, parts);
        break;
      } catch (const Error& error) {
        if (error.code() != ErrorCode::face_failed) throw;
        fail(error.where().face, error);
      }
    }
    parts_.clear();
    for (std::size_t i = 0; i < regions_.size(); ++i) {
      bool is_meshed = !joined_.node_of[i].empty();
      parts_.push_back({&regions_[i], is_meshed ? &paved_[i].mesh : nullptr, &joined_.node_of[i]});
    }
  }

  // Raises the order; returns the number of elements per face whose Jacobian is not proven positive.
  std::vector<long> curve() {
    SurfaceMesh& mesh = result_.mesh;
    std::vector<long> invalid(model_.faces.size(), 0);
    invalid_quads_.clear();
    invalid_triangles_.clear();
    if (options_.order == 1) {
      mesh = std::move(joined_.mesh);
      for (int q = 0; q < static_cast<int>(mesh.quad_count()); ++q)
        if (!is_valid(mesh, true, q)) invalid_quads_.push_back(q);
      for (int q : invalid_quads_) ++invalid[mesh.quad_face[q]];
      return invalid;
    }
    mesh = curve_elements(joined_.mesh, nodes_, model_, parts_, options_.threads, progress_);
    RepairResult repaired = repair_elements(mesh, is_valid);
    straightened_ = repaired.recentred + repaired.straightened;
    invalid_quads_ = repaired.invalid_quads;
    invalid_triangles_ = repaired.invalid_triangles;
    for (int q : repaired.invalid_quads) ++invalid[mesh.quad_face[q]];
    for (int t : repaired.invalid_triangles) ++invalid[mesh.triangle_face[t]];
    return invalid;
  }

  void note_invalid(const std::vector<long>& invalid) {
    auto& notes = result_.report.notes;
    if (straightened_ > 0)
      notes.push_back(fmt::format("{} curved elements were straightened to keep them valid.", straightened_));
    std::map<int, long> count;
    for (std::size_t face = 0; face < invalid.size(); ++face)
      if (invalid[face] > 0) count[model_.faces[face].origin] += invalid[face];
    for (auto [face, n] : count)
      notes.push_back(fmt::format("{} has {} elements that could not be made valid; use a smaller size or max-turn.",
                                  origin_name(face), n));
  }

  std::string origin_name(int origin) const { return "Face" + std::to_string(origin + 1); }

  // Faces divided along creases become one again: in the mesh, in the reports and in the names.
  void merge_pieces() {
    for (int& face : result_.mesh.quad_face) face = model_.faces[face].origin;
    for (int& face : result_.mesh.triangle_face) face = model_.faces[face].origin;
    std::vector<FaceReport> pieces = std::move(result_.report.faces);
    std::vector<std::string> names = std::move(result_.face_names);
    result_.report.faces.clear();
    result_.face_names.clear();
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      if (i > 0 && model_.faces[i].origin == model_.faces[i - 1].origin) {
        add_piece(result_.report.faces.back(), pieces[i]);
      } else {
        result_.report.faces.push_back(pieces[i]);
        result_.face_names.push_back(names[i]);
      }
    }
  }

  // A face has failed when one of its pieces has, and has no area when none of them has.
  static void add_piece(FaceReport& face, const FaceReport& piece) {
    bool is_worse = piece.status == FaceStatus::failed && face.status != FaceStatus::failed;
    bool is_first_area = piece.status == FaceStatus::meshed && face.status == FaceStatus::no_area;
    if (is_worse || is_first_area) {
      face.status = piece.status;
      face.stage = piece.stage;
      face.reason = piece.reason;
      face.where = piece.where;
    }
    face.cad_area += piece.cad_area;
    face.closed_by_triangulation += piece.closed_by_triangulation;
  }

  void measure() {
    begin(Stage::quality);
    double chord = chord_error(result_.mesh, parts_, options_.threads);  // by piece, as the regions are
    merge_pieces();
    std::vector<bool> is_periodic;
    for (const Edge& edge : model_.edges) is_periodic.push_back(edge.is_periodic);
    RunReport& report = result_.report;
    report.quality = measure_quality(result_.mesh, report.target_length, is_periodic, report.faces, progress_);
    report.quality.chord_error = chord;
    if (options_.elements == Elements::all_quad) note_triangles();
    end_stage();
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    report.peak_memory_mib = static_cast<double>(usage.ru_maxrss) / 1024;
  }

  void note_triangles() {
    std::string faces;
    for (const FaceReport& face : result_.report.faces)
      if (face.triangles > 0) faces += fmt::format("{}{} ({})", faces.empty() ? "" : ", ", face.name, face.triangles);
    if (!faces.empty()) result_.report.notes.push_back(fmt::format("Triangles remain in {}.", faces));
  }

  // Lines and nodes get the edges of the shape as read; in the model's own list there are pieces of these and others.
  void name_edges() {
    std::vector<int> number;
    auto& names = result_.edge_names;
    for (int e = 0; e < model_.read_edges; ++e) names.push_back("Edge" + std::to_string(e + 1));
    for (const Edge& edge : model_.edges) {
      number.push_back(edge.origins.empty() ? static_cast<int>(names.size()) : edge.origins.front());
      if (edge.origins.empty()) names.push_back(edge.name);
    }
    SurfaceMesh& mesh = result_.mesh;
    for (std::size_t line = 0; line < mesh.line_edge.size(); ++line) {
      int edge = mesh.line_edge[line];
      mesh.line_edge[line] = number[edge];
      const std::vector<int>& origins = model_.edges[edge].origins;
      for (std::size_t i = 1; i < origins.size(); ++i)
        mesh.further_edges.push_back({static_cast<int>(line), origins[i]});
    }
    for (int& edge : mesh.node_edge)
      if (edge >= 0) edge = number[edge];
  }

  const Options& options_;
  Progress& progress_;
  Stage stage_ = Stage::done;
  Clock::time_point started_;
  std::mutex mutex_;
  Model model_;
  SizeField size_;
  EdgeNodes nodes_;
  std::vector<Region> regions_;
  std::vector<PavedRegion> paved_;
  JoinedMesh joined_;
  std::vector<CurvingPart> parts_;
  long straightened_ = 0;
  std::vector<int> invalid_quads_, invalid_triangles_;
  MeshResult result_;
};

}  // namespace

MeshResult mesh_model(const CadModel& model, const Options& options, Progress& progress) {
  return guard_occt(ErrorCode::internal, kernel_failure, [&] { return Run(options, progress).mesh(model); });
}

MeshResult mesh_file(const std::string& path, const Options& options, Progress& progress) {
  check(options);
  return mesh_model(read_file(path, progress), options, progress);
}

Prediction predict(const CadModel& model, const Options& options, Progress& progress) {
  Options unlimited = options;
  unlimited.max_elements = std::numeric_limits<long>::max();
  return guard_occt(ErrorCode::internal, kernel_failure, [&] { return Run(unlimited, progress).predict(model); });
}

}  // namespace paver
