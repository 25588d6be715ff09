// Names of the objects of an assembly, given to their faces: "Board/Face3".
#pragma once

#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_TShape.hxx>
#include <map>
#include <string>
#include <unordered_map>
#include <vector>

namespace paver {

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

}  // namespace paver
