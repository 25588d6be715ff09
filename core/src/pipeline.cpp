// The whole job: one call per stage, every arrow one value.
// read -> topology -> sizing -> boundary nodes -> regions -> paving -> repair -> join -> curving -> quality
#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>

#include "assemble/assembler.h"
#include "base/tasks/gather.h"
#include "base/tasks/shared_tasks.h"
#include "base/tasks/stage_clock.h"
#include "base/tasks/tasks.h"
#include "boundary/edge_nodes.h"
#include "boundary/prediction.h"
#include "brep/occt_impl.h"
#include "check/distance/surface_distance.h"
#include "check/doubts.h"
#include "entries/face_entries.h"
#include "entries/names.h"
#include "entries/notes.h"
#include "entries/parts.h"
#include "parallel/pave_parts.h"
#include "paver/mesher.h"
#include "paver/ranks.h"
#include "quality/report.h"
#include "regions/divide_loops.h"
#include "repair/repair_parts.h"
#include "sizing/chord_lengths.h"
#include "sizing/gaps/divide_at_gaps.h"
#include "sizing/merging/merge_small.h"
#include "sizing/point_lengths.h"
#include "sizing/sample_box.h"
#include "topology/build_model.h"
#include "topology/named_parts.h"

namespace paver {
namespace {

constexpr const char* kernel_failure = "The CAD kernel failed at this model; report it with the model";

class Run {
 public:
  Run(const Options& options, Progress& progress, Ranks& ranks)
      : options_(options), progress_(progress), ranks_(ranks), shared_(options.threads, progress, ranks) {
    const std::vector<LocalSize> in_media = lengths_in_media(options);
    options_.local.insert(options_.local.end(), in_media.begin(), in_media.end());
  }

  MeshShare mesh(const CadModel& model) {
    start();
    build(model);
    if (!options_.chord_error) return mesh_built();
    return mesh_near_surface();
  }

  std::string repaired(const CadModel& model) {
    std::string brep;
    check(options_);
    build_model(*model.shape, options_, model.report, progress_, shared_, &brep);
    return brep;
  }

  std::vector<double> target_lengths(const CadModel& model, const std::vector<FacePoint>& points) {
    start();
    build(model);
    clock_.begin(Stage::sizing);
    return point_lengths(model_, build_size_field(model_, options_, progress_), points);
  }

  Prediction predict(const CadModel& model) {
    start();
    build(model);
    std::vector<FaceLayout> layouts;
    const EdgeCounts counts = count_intervals(ClosedLayouts::assumed, layouts);
    std::vector<double> elements = predict_elements(model_, size_, counts.count, options_.elements);
    Prediction prediction;
    prediction.target_length = result_.report.target_length;
    prediction.face_elements.assign(static_cast<std::size_t>(model_.read_faces) + model_.common.size(), 0);
    for (std::size_t i = 0; i < model_.faces.size(); ++i) {
      prediction.face_elements[model_.faces[i].origin] += elements[i];
      prediction.elements += elements[i];
    }
    prediction.merges = result_.report.merges;
    prediction.contacts = result_.report.model.contacts;
    prediction.memory_mib = predict_memory_mib(prediction.elements, options_);
    return prediction;
  }

 private:
  /// With shorter lengths on faces that are farther off than chord_error, until they are not.
  MeshShare mesh_near_surface() {
    const MeshShare built = share_;
    ChordLengths lengths(*options_.chord_error, options_.order);
    MeshShare done = mesh_built();
    RunReport& report = done.result.report;
    while (true) {
      const ShorterLengths more = lengths.next(report.faces, entry_lengths(report.faces), far_);
      if (more.is_empty()) break;
      options_.local.insert(options_.local.end(), more.faces.begin(), more.faces.end());
      places_.insert(places_.end(), more.places.begin(), more.places.end());
      share_ = built;
      result_.report.stage_seconds = report.stage_seconds;
      result_.report.stage_runs = report.stage_runs;
      try {
        done = mesh_built();
      } catch (const Error& error) {
        if (error.code() != ErrorCode::too_many_elements) throw;
        break;  // the last mesh that is small enough, and where it is too far off
      }
    }
    if (const std::string note = lengths.note(report.faces); !note.empty()) report.notes.push_back(note);
    return done;
  }

  // All stages after topology.
  MeshShare mesh_built() {
    divide();
    PartPaver paver(regions_, costs(), static_cast<int>(nodes_.nodes.size()), options_, progress_, ranks_, queue_);
    pave(paver);
    queue_ = paver.next_queue();
    clock_.begin(Stage::repair);
    result_.report.element_repairs = repair_parts(model_, regions_, options_, nodes_, paver, progress_, ranks_);
    note_repairs(result_.report);
    Assembler assembler(
        model_, nodes_, regions_, paver, options_, progress_, ranks_, [this](Stage stage) { clock_.begin(stage); },
        share_);
    assembler.run();
    measure();
    while (assembler.drop_faulty()) measure();
    assembler.note_straightened();
    assembler.number();
    result_.report.tasks = shared_.times();
    result_.report.tasks.insert(result_.report.tasks.end(), paver.times().begin(), paver.times().end());
    finish(assembler);
    name_edges(model_, result_);
    name_points(model_, result_);
    measure_segments(options_, result_);
    result_.face_groups = model_.face_group;
    result_.volumes = list_volumes(model_);
    result_.report.lost_parts = lost_parts(options_, model_, result_);
    return std::move(share_);
  }

  /// Per entry of the report, which are faces as read: the least length of their pieces.
  std::vector<double> entry_lengths(const std::vector<FaceReport>& entries) const {
    std::vector<double> length(entries.size(), INFINITY);
    for (std::size_t f = 0; f < model_.faces.size(); ++f) {
      double& least = length[model_.faces[f].origin];
      least = std::min(least, size_.face_h[f]);
    }
    return length;
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
    clock_.begin(Stage::topology);
    model_ = build_model(*model.shape, options_, model.report, progress_, shared_);
    name_parts(model_, options_);
    result_.report.wavelength = wavelength(options_);
    result_.report.media = options_.media;
    result_.report.ports = options_.ports;
    result_.report.wires = options_.wires;
    const CoplanarTriangles coplanar = join_coplanar_triangles(model_, options_);
    const std::vector<Merge> small = merge_small(model_, options_);
    if (!small.empty()) note_free_edges(model_);  // tips cut off are closed now
    divide_at_gaps(model_, options_);
    result_.report.model = model_.report;
    result_.report.notes = model_.notes;
    for (const std::string& note : notes_of(coplanar)) result_.report.notes.push_back(note);
    if (const std::string note = note_merges(small); !note.empty()) result_.report.notes.push_back(note);
    result_.report.merges = coplanar.merges;
    result_.report.merges.insert(result_.report.merges.end(), small.begin(), small.end());
    list_faces(model_, options_, result_);
  }

  // Sizing, and the number of intervals of every edge.
  EdgeCounts count_intervals(ClosedLayouts closed, std::vector<FaceLayout>& layouts) {
    clock_.begin(Stage::sizing);
    size_ = build_size_field(model_, options_, progress_, places_);
    for (const std::string& note : size_.local->notes()) result_.report.notes.push_back(note);
    clock_.begin(Stage::boundary);
    layouts = plan_layouts(model_, size_, closed, progress_);
    EdgeCounts counts = choose_counts(model_, size_, progress_, shared_, options_.elements == Elements::all_quad);
    settle_counts(model_, layouts, counts.count);
    check_counts(counts.count);
    return counts;
  }

  /// Before nodes are made: no face has so many sides on its border that an element has more than two of them, but for
  /// few, and each is on two faces at most.
  void check_counts(const std::vector<int>& counts) const {
    const double sides = std::accumulate(counts.begin(), counts.end(), 0.0);
    if (0.5 * sides <= static_cast<double>(options_.max_elements)) return;
    throw Error(ErrorCode::too_many_elements,
                fmt::format("Edges would be divided into {:.3g} sides, too many for the limit of {} elements; choose "
                            "longer lengths, a larger max_turn, or raise max_elements.",
                            sides, options_.max_elements),
                {"boundary", -1, -1, std::nullopt});
  }

  // Boundary nodes and regions; faces whose loops cross are none of them.
  void divide() {
    std::vector<FaceLayout> layouts;
    const EdgeCounts counts = count_intervals(ClosedLayouts::made, layouts);
    const std::vector<double> predicted = predict_elements(model_, size_, counts.count, options_.elements);
    predicted_ = std::accumulate(predicted.begin(), predicted.end(), 0.0);
    DividedLoops divided = divide_loops(model_, size_, layouts, counts, options_.order > 1, shared_);
    nodes_ = std::move(divided.nodes);
    regions_ = std::move(divided.regions);
    for (const CrossingFace& failure : divided.failures)
      result_.report.faces[failure.face].fail(stage_name(Stage::regions), failure.reason, failure.where);
    clock_.begin(Stage::regions);
  }

  // About the elements to be paved.
  std::vector<double> costs() const {
    constexpr double filling = 0.08;  // an element of a structured layout, where one that is paved costs 1
    std::vector<double> cost;
    for (const Region& region : regions_)
      cost.push_back(region.fill ? filling * static_cast<double>(region.fill->quads())
                                 : model_.faces[region.face].area / (region.h * region.h));
    return cost;
  }

  void pave(PartPaver& paver) {
    clock_.begin(Stage::paving);
    report_failures(paver.pave(), regions_, result_.report);
    std::vector<long> closed(regions_.size(), 0);
    for (const Part& part : paver.parts())
      if (part.paved) closed[part.region] += part.paved->closed_by_triangulation;
    ranks_.add_up(closed);
    for (std::size_t r = 0; r < regions_.size(); ++r)
      result_.report.faces[regions_[r].face].closed_by_triangulation += closed[r];
  }

  void measure() {
    clock_.begin(Stage::quality);
    std::vector<bool> is_periodic;
    for (const Edge& edge : model_.edges) is_periodic.push_back(edge.is_periodic);
    RunReport& report = result_.report;
    report.quality = measure_quality(share_, report.target_length, is_periodic, report.faces, progress_, ranks_);
  }

  void finish(const Assembler& assembler) {
    RunReport& report = result_.report;
    const MeshDistances distances =
        assembler.distances(ChordLengths::near_enough * options_.chord_error.value_or(INFINITY));
    keep_far(distances.far);
    long elements = 0;
    for (std::size_t f = 0; f < distances.faces.size(); ++f) {
      FaceReport& face = report.faces[f];
      const long more = face.quads + face.triangles;
      face.distance = distances.faces[f];
      report.quality.distance = join_distances(report.quality.distance, elements, face.distance, more);
      elements += more;
    }
    report.quality.metric = assembler.metric();
    report.quality.metric.predicted = predicted_;
    find_doubts(MeshPieces(result_.mesh, model_, ranks_), model_, ranks_, report);
    merge_pieces(model_, result_);
    count_wire_lines(model_, result_);
    report.components = find_components(model_, report.faces);
    const bool has_failed = std::ranges::count(report.faces, FaceStatus::failed, &FaceReport::status) > 0;
    if (options_.connect != Connect::none && !has_failed)
      std::ranges::move(contacts_apart(report.model.contacts, report.components),
                        std::back_inserter(report.model.unconnected));
    note_remaining(report);
    note_far_faces(report);
    clock_.end();
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    report.peak_memory_mib = static_cast<double>(usage.ru_maxrss) / 1024;
  }

  /// For the next mesh. A face without a border is laid in one piece: it gets another length as a whole only.
  void keep_far(const std::vector<FarPlace>& far) {
    far_.clear();
    for (FarPlace place : far) {
      const auto face = static_cast<std::size_t>(place.face);
      if (!has_border(model_, model_.faces[face])) continue;
      place.face = model_.faces[face].origin;
      place.target = size_.faces[face].given_at(0.5 * (place.x[0] + place.x[place.corners > 2 ? 2 : 1]));
      far_.push_back(place);
    }
  }

  Options options_;  // with the lengths that chord_error asks for
  Progress& progress_;
  Ranks& ranks_;
  Model model_;
  std::vector<SizeSource> places_;  // likewise
  std::vector<FarPlace> far_;       // in the last mesh, by entries of the report
  SizeField size_;
  double predicted_ = 0;  // elements
  EdgeNodes nodes_;
  std::vector<Region> regions_;
  SharedTasks shared_;
  int queue_ = 0;  // of the ranks: the first that no mesh has used
  MeshShare share_;
  MeshResult& result_ = share_.result;
  StageClock clock_{result_.report, progress_};
};

Options unlimited(Options options) {
  options.max_elements = std::numeric_limits<long>::max();
  return options;
}

template <class Work>
auto on_one_rank(const Options& options, Progress& progress, Work work) {
  SingleRank alone;
  return guard_occt(ErrorCode::internal, kernel_failure, progress, [&] { return work(Run(options, progress, alone)); });
}

}  // namespace

MeshShare mesh_share(const CadModel& model, const Options& options, Progress& progress, Ranks& ranks) {
  check(options);
  return guard_occt(ErrorCode::internal, kernel_failure, progress, [&] {
    MeshShare share;
    run_in_arena(options.threads, [&] { share = Run(options, progress, ranks).mesh(model); });
    return share;
  });
}

MeshResult mesh_model(const CadModel& model, const Options& options, Progress& progress) {
  SingleRank alone;
  return mesh_share(model, options, progress, alone).result;
}

MeshResult mesh_file(const std::string& path, const Options& options, Progress& progress) {
  check(options);
  return mesh_model(read_file(path, progress), options, progress);
}

std::string repaired_model(const CadModel& model, const Options& options, Progress& progress) {
  return on_one_rank(options, progress, [&](Run run) { return run.repaired(model); });
}

Prediction predict(const CadModel& model, const Options& options, Progress& progress) {
  return on_one_rank(unlimited(options), progress, [&](Run run) { return run.predict(model); });
}

std::vector<double> target_lengths(const CadModel& model, const Options& options, const std::vector<FacePoint>& points,
                                   Progress& progress) {
  return on_one_rank(unlimited(options), progress, [&](Run run) { return run.target_lengths(model, points); });
}

}  // namespace paver
