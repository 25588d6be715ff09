// STEP: reads the file, transfers all roots in millimetres, and takes the names of its objects and faces along.
#include <Bnd_Box.hxx>
#include <STEPControl_Reader.hxx>
#include <StepBasic_Product.hxx>
#include <StepBasic_ProductDefinition.hxx>
#include <StepBasic_ProductDefinitionFormation.hxx>
#include <StepGeom_Axis2Placement3d.hxx>
#include <StepGeom_CartesianPoint.hxx>
#include <StepRepr_HArray1OfRepresentationItem.hxx>
#include <StepRepr_ProductDefinitionShape.hxx>
#include <StepRepr_Representation.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <StepShape_FaceSurface.hxx>
#include <StepShape_ShapeDefinitionRepresentation.hxx>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <gp_Pnt.hxx>
#include <map>
#include <string_view>

#include "formats/step_impl.h"
#include "formats/transfer_impl.h"

namespace paver {
namespace {

/// How far the readers may move what does not meet, mm. As ReaderSetting.
class LargestTolerance {
 public:
  explicit LargestTolerance(double value) : saved_(Interface_Static::RVal(name)) {
    Interface_Static::SetRVal(name, value);
  }
  ~LargestTolerance() { Interface_Static::SetRVal(name, saved_); }
  LargestTolerance(const LargestTolerance&) = delete;
  LargestTolerance& operator=(const LargestTolerance&) = delete;

 private:
  static constexpr const char* name = "read.maxprecision.val";
  double saved_;
};

Handle(StepRepr_RepresentationItem) any_placement(const Handle(Interface_InterfaceModel) & model) {
  for (int i = 1; i <= model->NbEntities(); ++i)
    if (const auto placement = Handle(StepGeom_Axis2Placement3d)::DownCast(model->Value(i)); !placement.IsNull())
      return Handle(StepRepr_RepresentationItem)(placement);
  return nullptr;
}

/// Whether a representation is one of a dimension or a note, and of no part.
bool is_of_notes(const Handle(Interface_InterfaceModel) & model, const Handle(StepRepr_Representation) & one) {
  bool is_any = false;
  for (int i = 1; i <= model->NbEntities(); ++i) {
    const auto link = Handle(StepShape_ShapeDefinitionRepresentation)::DownCast(model->Value(i));
    if (link.IsNull() || link->UsedRepresentation() != one) continue;
    if (!Handle(StepRepr_ProductDefinitionShape)::DownCast(link->Definition().Value()).IsNull()) return false;
    is_any = true;
  }
  return is_any;
}

/// Takes out of a representation what could not be loaded: newer kinds than the kernel knows, as tessellated solids and
/// notes on drawings, may stand beside those it knows, or be a representation of their own. That gets a placement, as
/// the kernel knows no empty ones. False where `entity` is of no use without.
bool go_without_items(const Handle(Interface_InterfaceModel) & model, const Handle(Standard_Transient) & entity) {
  if (const auto link = Handle(StepShape_ShapeDefinitionRepresentation)::DownCast(entity); !link.IsNull())
    return link->UsedRepresentation().IsNull();
  const auto representation = Handle(StepRepr_Representation)::DownCast(entity);
  if (representation.IsNull() || representation->Items().IsNull()) return false;
  std::vector<Handle(StepRepr_RepresentationItem)> known;
  for (int i = 1; i <= representation->NbItems(); ++i)
    if (!representation->ItemsValue(i).IsNull()) known.push_back(representation->ItemsValue(i));
  if (known.empty()) known.push_back(any_placement(model));
  if (known.front().IsNull()) return false;
  Handle(StepRepr_HArray1OfRepresentationItem) items =
      new StepRepr_HArray1OfRepresentationItem(1, static_cast<int>(known.size()));
  for (std::size_t i = 0; i < known.size(); ++i) items->SetValue(static_cast<int>(i) + 1, known[i]);
  representation->SetItems(items);
  return true;
}

/// The reader marks entities whose content it could not load, and crashes later where it follows them into geometry.
/// Gives the labels of representations that it can do without some of their items.
std::vector<std::string> check_entities(const std::string& name, STEPControl_Reader& reader) {
  std::vector<std::string> incomplete;
  Handle(Interface_InterfaceModel) model = reader.Model();
  for (int i = 1; i <= model->NbEntities(); ++i) {
    if (!model->IsErrorEntity(i)) continue;
    Handle(Standard_Transient) entity = model->Value(i);
    std::string_view type = entity->DynamicType()->Name();
    if (!type.starts_with("StepGeom_") && !type.starts_with("StepShape_")) continue;
    const char* const reason = fail_of(model, i);
    if (!reason) continue;
    if (!go_without_items(model, entity))
      throw Error(ErrorCode::damaged_file, "'" + name + "' is damaged at entity " +
                                               model->StringLabel(entity)->ToCString() + " (" + reason +
                                               "); export the model again.");
    if (const auto representation = Handle(StepRepr_Representation)::DownCast(entity);
        !representation.IsNull() && !is_of_notes(model, representation))
      incomplete.push_back(entity_label(reader, entity) + " (items)");
  }
  return incomplete;
}

Handle(TCollection_HAsciiString) face_name(const Handle(Standard_Transient) & entity) {
  Handle(StepShape_FaceSurface) face = Handle(StepShape_FaceSurface)::DownCast(entity);
  return face.IsNull() ? Handle(TCollection_HAsciiString)() : face->Name();
}

/// Names of the objects of an assembly, given to their faces: "Board/Face3".
class ObjectLabels {
 public:
  /// What `shape` is called, wherever in an assembly it stands.
  void add(const TopoDS_Shape& shape, const std::string& name) {
    if (!shape.IsNull() && !name.empty()) names_[shape.TShape().get()] = name;
  }

  /// Puts the object before each label, which is "Face3", counted in the object, where the face has none of its own. An
  /// object that is there several times is "Bolt:1", "Bolt:2". A model of a single object is left as it is.
  /// `labels`: in the order of TopExp::MapShapes.
  void give_to(const TopoDS_Shape& assembly, std::vector<std::string>& labels) {
    TopExp::MapShapes(assembly, TopAbs_FACE, faces_);
    object_of_.assign(static_cast<std::size_t>(faces_.Extent()), -1);
    visit(assembly, -1);
    std::map<std::string, int> uses, given;
    for (const Object& object : objects_)
      if (object.faces > 0) ++uses[object.name];
    if (uses.size() < 2 && (uses.empty() || uses.begin()->second < 2)) return;
    for (Object& object : objects_) {
      const std::string name = object.name;
      if (object.faces > 0 && uses[name] > 1) object.name.append(":").append(std::to_string(++given[name]));
      object.faces = 0;
    }
    for (std::size_t f = 0; f < object_of_.size(); ++f) {
      if (object_of_[f] < 0) continue;
      Object& object = objects_[object_of_[f]];
      ++object.faces;
      if (labels[f].empty()) labels[f].append("Face").append(std::to_string(object.faces));
      labels[f].insert(0, object.name + "/");
    }
  }

 private:
  struct Object {
    std::string name;
    int faces = 0;  // of its own; an assembly whose faces are all in other objects has none
  };

  /// `object`: the innermost one around, negative where there is none. A face is of the first object that has it.
  void visit(const TopoDS_Shape& shape, int object) {
    if (auto named = names_.find(shape.TShape().get()); named != names_.end()) {
      object = static_cast<int>(objects_.size());
      objects_.push_back({named->second});
    }
    if (shape.ShapeType() < TopAbs_FACE) {
      for (TopoDS_Iterator inner(shape); inner.More(); inner.Next()) visit(inner.Value(), object);
    } else if (shape.ShapeType() == TopAbs_FACE && object >= 0) {
      int& known = object_of_[faces_.FindIndex(shape) - 1];
      if (known >= 0) return;
      known = object;
      ++objects_[object].faces;
    }
  }

  std::unordered_map<const TopoDS_TShape*, std::string> names_;
  TopTools_IndexedMapOfShape faces_;
  std::vector<Object> objects_;
  std::vector<int> object_of_;  // per face
};

/// Of a part, as its writer calls it; empty where it only says who wrote it.
std::string product_name(const Handle(StepBasic_ProductDefinition) & definition) {
  if (definition->Formation().IsNull() || definition->Formation()->OfProduct().IsNull()) return "";
  Handle(StepBasic_Product) product = definition->Formation()->OfProduct();
  for (Handle(TCollection_HAsciiString) text : {product->Name(), product->Id()})
    if (!text.IsNull() && !text->IsEmpty())
      return text->String().StartsWith("Open CASCADE STEP translator") ? "" : text->ToCString();
  return "";
}

/// Past the mark of UTF-8 that some editors put in front: the kernel's grammar knows no such token.
void skip_byte_order_mark(std::istream& content) {
  std::string start(3, '\0');
  if (!content.read(start.data(), 3) || start != "\xEF\xBB\xBF") content.clear(), content.seekg(0);
}

/// Whether every letter beyond ASCII is one of UTF-8, as far as counts of bytes tell.
bool is_utf8(std::string_view content) {
  int open = 0;  // bytes of a letter that are still to come
  for (const char byte : content) {
    const auto letter = static_cast<unsigned char>(byte);
    const bool is_inner = (letter & 0xC0U) == 0x80U;
    if (is_inner != (open > 0) || letter >= 0xF8U) return false;
    open = is_inner ? open - 1 : letter >= 0xF0U ? 3 : letter >= 0xE0U ? 2 : letter >= 0xC0U ? 1 : 0;
  }
  return open == 0;
}

/// How far the kernel may move what does not meet, mm: as by itself, but no more than a small share of the model. It
/// drops edges that are shorter.
double most_imprecise(STEPControl_Reader& reader) {
  constexpr double by_itself = 1, most_share = 0.01;
  Bnd_Box box;
  double unit = 0;
  for (const Handle(Standard_Transient) & entity : entities_of(reader)) {
    const auto point = Handle(StepGeom_CartesianPoint)::DownCast(entity);
    if (!point.IsNull() && point->NbCoordinates() == 3)
      box.Add(gp_Pnt(point->CoordinatesValue(1), point->CoordinatesValue(2), point->CoordinatesValue(3)));
    unit = std::max(unit, largest_unit(entity));
  }
  if (box.IsVoid() || !(unit > 0)) return by_itself;
  return std::min(by_itself, most_share * unit * std::sqrt(box.SquareExtent()));
}

void label_objects(STEPControl_Reader& reader, Shape& shape) {
  ObjectLabels objects;
  for (const Handle(Standard_Transient) & entity : entities_of(reader))
    if (const auto definition = Handle(StepBasic_ProductDefinition)::DownCast(entity); !definition.IsNull())
      objects.add(shape_of(reader, definition), product_name(definition));
  objects.give_to(shape.shape, shape.labels);
}

}  // namespace

extern "C" void paver_read_format(const FileSource& file, std::string_view content, const Doubt& doubt, Shape& shape,
                                  ModelReport& report, Progress& progress) {
  STEPControl_Reader reader;
  const ReaderSetting millimetres("xstep.cascade.unit", "MM");
  const ReaderSetting no_triangles("read.step.tessellated", "Off");  // of newer kernels: faces without surfaces
  // Older writers put in letters of their own.
  const ReaderSetting letters("read.step.codepage", is_utf8(content) ? "UTF8" : "CP1252");
  std::ifstream stream(file.path, std::ios::binary);  // OpenCASCADE 7.8 opens no path that is not UTF-8
  skip_byte_order_mark(stream);
  check_loaded(reader.ReadStream(file.path.c_str(), stream), file, "STEP", progress);
  const auto add = [&](const std::vector<std::string>& labels) {
    report.unread.insert(report.unread.end(), labels.begin(), labels.end());
  };
  add(check_entities(file.name, reader));
  if (has_fails(reader.Model())) doubt();
  const LargestTolerance tolerance(most_imprecise(reader));
  report.unit = stated_unit(reader);
  lead_meridians_to_poles(reader);
  transfer(reader, shape, progress, face_name);
  add(step_losses(reader));
  if (shape.shape.IsNull()) return;
  report.open_solids = open_solids(reader);
  label_objects(reader, shape);
  restore_sides(reader, shape);
}

}  // namespace paver
