// The list of options, each with the function that puts its value where it belongs.
#include "paver/option_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/local_parts.h"
#include "base/options/named_options.h"
#include "paver/error.h"
#include "paver/units.h"

namespace paver {
namespace {

/// A value as read: numbers in mm, Hz, radians; `index` of a choice; `local` of parts; the text of what is named.
struct Value {
  double number = 0;
  int index = 0;
  std::vector<LocalSize> local;
  std::string text;
};

struct Entry {
  OptionInfo info;
  void (*put)(Options&, const Value&);
};

/// Of a choice whose values are those of an enumeration, in its order.
template <class T>
std::vector<std::string> names_of(int choices, const char* (*name)(T)) {
  std::vector<std::string> names;
  for (int i = 0; i < choices; ++i) names.emplace_back(name(static_cast<T>(i)));
  return names;
}

constexpr const char* flag_texts[] = {"off", "on"};

/// Choices of gap, of one element across and more.
std::vector<std::string> gap_choices() {
  return {"one", "refine:2", "refine:3", "refine:4", "refine:5", "refine:6", "refine:7", "refine:8"};
}

/// Choices of multilevel; from the third on the numbers from 4.
std::vector<std::string> level_choices() { return {"off", "auto", "4", "5", "6", "7", "8"}; }

int level_value(int choice) {
  constexpr int first_number = 2, least_ratio = 4;
  if (choice >= first_number) return choice - first_number + least_ratio;
  return choice == 0 ? 0 : automatic_levels;
}

template <class T>
std::string text_of(T value) {
  return fmt::format("{}", value);
}

std::vector<Entry> size_entries(const Options& d) {
  return {
      {{"size", OptionKind::length, "H", "Target length of the element edges, e.g. 30, \"30 mm\", 1.5in"},
       [](Options& o, const Value& v) { o.size = v.number; }},
      {{"frequency", OptionKind::frequency, "F", "Working frequency instead of size, e.g. 3GHz, \"300 MHz\", 9e9", "",
        "", "size"},
       [](Options& o, const Value& v) { o.frequency = v.number; }},
      {{"divisions", OptionKind::number, "N", "Elements per wavelength", text_of(d.divisions), "frequency"},
       [](Options& o, const Value& v) { o.divisions = v.number; }},
      {{"eps_r", OptionKind::number, "E", "Relative permittivity of the medium", text_of(d.eps_r), "frequency"},
       [](Options& o, const Value& v) { o.eps_r = v.number; }},
      {{"mu_r", OptionKind::number, "M", "Relative permeability of the medium", text_of(d.mu_r), "frequency"},
       [](Options& o, const Value& v) { o.mu_r = v.number; }},
  };
}

std::vector<Entry> grading_entries(const Options& d) {
  return {
      {{"max_turn", OptionKind::angle, "DEG",
        "Largest turn of the surface per element edge, degrees [45; 75 where that stays as close]"},
       [](Options& o, const Value& v) { o.max_turn = v.number; }},
      {{"aspect", OptionKind::number, "A",
        "Across a ridge elements are at most so many times narrower than along it; 1: not narrower", text_of(d.aspect)},
       [](Options& o, const Value& v) { o.aspect = v.number; }},
      {{"gradation", OptionKind::number, "G", "Largest growth of the element size per unit of length",
        text_of(d.gradation)},
       [](Options& o, const Value& v) { o.gradation = v.number; }},
      {{"tip", OptionKind::number, "R", "Where the surface comes to a point the target length is divided by R; 1: not",
        text_of(d.tip)},
       [](Options& o, const Value& v) { o.tip = v.number; }},
      {{"grade_edges", OptionKind::number, "R", "At sharp outer edges the target length is divided by R; 1: not",
        text_of(d.grade_edges)},
       [](Options& o, const Value& v) { o.grade_edges = v.number; }},
      {{"gap", OptionKind::choice, "HOW",
        "Faces narrower than 0.7 target lengths: one element across; refine:K: shorter ones, about K across",
        gap_choices()[static_cast<std::size_t>(d.gap_elements) - 1], "", "", gap_choices()},
       [](Options& o, const Value& v) { o.gap_elements = v.index + 1; }},
      {{"chord_error", OptionKind::length, "E",
        "Largest distance between mesh and surface: what is farther off gets shorter lengths [as it comes]"},
       [](Options& o, const Value& v) { o.chord_error = v.number; }},
      {{"local", OptionKind::local, "PART=H",
        "Target length of a part where shorter: Face3=2mm, Edge5,Vertex2=0.5, Solid1=eps-r:4; may be repeated"},
       [](Options& o, const Value& v) { o.local.insert(o.local.end(), v.local.begin(), v.local.end()); }},
      {{"max_elements", OptionKind::integer, "N", "Stop before meshing when more elements are predicted",
        text_of(d.max_elements)},
       [](Options& o, const Value& v) { o.max_elements = static_cast<long>(v.number); }},
  };
}

std::vector<Entry> named_entries() {
  return {
      {{"medium", OptionKind::named, "NAME=PARTS",
        "What solids are made of: FR4=Solid1,eps-r:4.4,tan-d:0.02, Metal=Solid2,conductor; may be repeated"},
       [](Options& o, const Value& v) { o.media.push_back(*parse_medium(v.text)); }},
      {{"port", OptionKind::named, "NAME=PARTS",
        "Faces, edges, vertices that are a group of the mesh: Feed=Edge5; never merged with others; may be repeated"},
       [](Options& o, const Value& v) { o.ports.push_back(*parse_port(v.text)); }},
      {{"wire", OptionKind::named, "NAME=PARTS",
        "Edges that stand for a thin wire: Mast=Edge5,radius:0.5mm; may be repeated"},
       [](Options& o, const Value& v) { o.wires.push_back(*parse_wire(v.text)); }},
  };
}

std::vector<Entry> merging_entries(const Options& d) {
  return {
      {{"merge", OptionKind::number, "E",
        "Edges shorter than E target lengths are merged with others; off: nothing is merged", text_of(d.merge)},
       [](Options& o, const Value& v) { o.merge = v.number; }},
      {{"merge_width", OptionKind::number, "W",
        "Faces narrower than W target lengths are merged with neighbours that run on without a corner",
        text_of(d.merge_width)},
       [](Options& o, const Value& v) { o.merge_width = v.number; }},
  };
}

std::vector<Entry> other_entries(const Options& d) {
  return {
      {{"order", OptionKind::integer, "P", "Order of the elements, 1 or 2", text_of(d.order)},
       [](Options& o, const Value& v) { o.order = static_cast<int>(v.number); }},
      {{"elements", OptionKind::choice, "KIND",
        "quad-dominant; all-quad: triangles only where nothing else is possible; all-triangle",
        elements_name(d.elements), "", "", names_of(3, elements_name)},
       [](Options& o, const Value& v) { o.elements = static_cast<Elements>(v.index); }},
      {{"multilevel", OptionKind::choice, "K",
        "Mesh large faces at K times the target length first and divide that mesh: off, auto, 4 to 8",
        level_choices()[1], "", "", level_choices()},
       [](Options& o, const Value& v) { o.multilevel = level_value(v.index); }},
      {{"threads", OptionKind::integer, "T", "Threads to work on; 0: all cores", text_of(d.threads)},
       [](Options& o, const Value& v) { o.threads = static_cast<int>(v.number); }},
      {{"ranks", OptionKind::integer, "N", "Processes that share the work, by MPI; 0: without MPI", text_of(d.ranks)},
       [](Options& o, const Value& v) { o.ranks = static_cast<int>(v.number); }},
      {{"connect", OptionKind::choice, "HOW",
        "Parts that touch: imprint: share faces and edges; union: only the outer skin is left; none: as drawn",
        connect_name(d.connect), "", "", names_of(3, connect_name)},
       [](Options& o, const Value& v) { o.connect = static_cast<Connect>(v.index); }},
      {{.name = "sew_tolerance",
        .kind = OptionKind::length,
        .letter = "T",
        .help = "Largest gap between faces or parts that is closed; 0: never sew [chosen by what it closes]",
        .may_be_zero = true},
       [](Options& o, const Value& v) { o.sew_tolerance = v.number; }},
      {{"strict", OptionKind::flag, "ON",
        "Refuse models that are not clean, naming what is wrong, instead of repairing them", flag_texts[d.strict]},
       [](Options& o, const Value& v) { o.strict = v.index != 0; }},
  };
}

const std::vector<Entry>& entries() {
  static const std::vector<Entry> all = [] {
    Options defaults;
    std::vector<Entry> list = size_entries(defaults);
    for (const std::vector<Entry>& more :
         {grading_entries(defaults), named_entries(), merging_entries(defaults), other_entries(defaults)})
      list.insert(list.end(), more.begin(), more.end());
    return list;
  }();
  return all;
}

/// A whole number that an int holds exactly.
std::optional<double> parse_integer(const std::string& text) {
  constexpr double largest = 2'000'000'000;
  std::optional<double> value = parse_number(text);
  if (value && (*value != std::floor(*value) || std::abs(*value) > largest)) return std::nullopt;
  return value;
}

std::string examples_of(const OptionInfo& info) {
  switch (info.kind) {
    case OptionKind::length:
      return "30, 30mm, 1.5in or 2m";
    case OptionKind::frequency:
      return "3GHz, 300MHz or 9e9";
    case OptionKind::angle:
      return "30, 30deg or 0.5rad";
    case OptionKind::number:
      return "1.5";
    case OptionKind::integer:
      return "2, a whole number";
    case OptionKind::local:
      return "Face3=2mm, Edge5,Vertex2=0.5mm or Solid1=eps-r:4";
    case OptionKind::named:
      return info.name == "medium" ? medium_example : info.name == "port" ? port_example : wire_example;
    case OptionKind::flag:
      return "on or off";
    case OptionKind::choice:
      break;
  }
  std::string names;
  for (std::size_t i = 0; i < info.choices.size(); ++i)
    names += (i == 0 ? "" : i + 1 < info.choices.size() ? ", " : " or ") + info.choices[i];
  return names;
}

/// Whether text is of the form that an option of the kind `named` has.
bool is_named(const std::string& name, const std::string& text) {
  if (name == "medium") return parse_medium(text).has_value();
  return name == "port" ? parse_port(text).has_value() : parse_wire(text).has_value();
}

std::optional<Value> read_value(const OptionInfo& info, const std::string& text) {
  auto number = [](std::optional<double> value) {
    return value ? std::optional<Value>({*value, 0, {}, {}}) : std::nullopt;
  };
  switch (info.kind) {
    case OptionKind::length:
      return number(parse_length(text));
    case OptionKind::frequency:
      return number(parse_frequency(text));
    case OptionKind::angle:
      return number(parse_angle(text));
    case OptionKind::number:
      return number(text == "off" ? 0 : parse_number(text));
    case OptionKind::integer:
      return number(parse_integer(text));
    case OptionKind::local:
      if (auto local = parse_local(text)) return Value{0, 0, *std::move(local), {}};
      return std::nullopt;
    case OptionKind::named:
      return is_named(info.name, text) ? std::optional<Value>({0, 0, {}, text}) : std::nullopt;
    case OptionKind::flag:
      if (text == flag_texts[0] || text == flag_texts[1]) return Value{0, text == flag_texts[1], {}, {}};
      return std::nullopt;
    case OptionKind::choice:
      break;
  }
  auto found = std::find(info.choices.begin(), info.choices.end(), text);
  if (found == info.choices.end()) return std::nullopt;
  return Value{0, static_cast<int>(found - info.choices.begin()), {}, {}};
}

const Entry& entry_of(const std::string& name) {
  for (const Entry& entry : entries())
    if (entry.info.name == name) return entry;
  throw Error(ErrorCode::bad_option, fmt::format("There is no option '{}'; look at the list of options.", name));
}

void check_company(const OptionInfo& info, const std::vector<GivenOption>& given) {
  auto is_given = [&](const std::string& name) {
    return std::any_of(given.begin(), given.end(), [&](const GivenOption& option) { return option.first == name; });
  };
  if (!info.needs.empty() && !is_given(info.needs)) {
    throw Error(ErrorCode::bad_option, fmt::format("{} needs {}; give both or neither.", info.name, info.needs));
  }
  if (!info.excludes.empty() && is_given(info.excludes)) {
    throw Error(ErrorCode::bad_option, fmt::format("{} excludes {}; give only one of them.", info.name, info.excludes));
  }
}

}  // namespace

const char* kind_name(OptionKind kind) {
  static constexpr const char* names[] = {"length", "frequency", "angle", "number", "integer",
                                          "choice", "flag",      "local", "named"};
  static_assert(std::size(names) == static_cast<std::size_t>(OptionKind::named) + 1);
  return names[static_cast<std::size_t>(kind)];
}

const std::vector<OptionInfo>& option_table() {
  static const std::vector<OptionInfo> table = [] {
    std::vector<OptionInfo> list;
    for (const Entry& entry : entries()) list.push_back(entry.info);
    return list;
  }();
  return table;
}

bool is_repeated(OptionKind kind) { return kind == OptionKind::local || kind == OptionKind::named; }

Options read_options(const std::vector<GivenOption>& given) {
  Options options;
  for (const auto& [name, text] : given) {
    const Entry& entry = entry_of(name);
    check_company(entry.info, given);
    std::optional<Value> value = read_value(entry.info, text);
    if (!value) {
      throw Error(ErrorCode::bad_option,
                  fmt::format("{} is '{}'; write it like {}.", name, text, examples_of(entry.info)));
    }
    entry.put(options, *value);
  }
  return options;
}

}  // namespace paver
