// Names that a file gives to its faces, brought into the order of the faces in the shape.
#pragma once

#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_TShape.hxx>
#include <string>
#include <unordered_map>
#include <vector>

namespace paver {

class FaceLabels {
 public:
  /// Gives `label` to every face of `shape`. Names that say nothing are left out.
  void add(const TopoDS_Shape& shape, const std::string& label) {
    if (shape.IsNull() || label.empty() || label == "NONE" || label == "none") return;
    for (TopExp_Explorer faces(shape, TopAbs_FACE); faces.More(); faces.Next())
      labels_[faces.Current().TShape().get()] = label;
  }

  /// Labels in the order of TopExp::MapShapes.
  std::vector<std::string> in_face_order(const TopoDS_Shape& shape) const {
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(shape, TopAbs_FACE, faces);
    std::vector<std::string> result(static_cast<std::size_t>(faces.Extent()));
    for (int i = 1; i <= faces.Extent(); ++i) {
      auto found = labels_.find(faces(i).TShape().get());
      if (found != labels_.end()) result[static_cast<std::size_t>(i - 1)] = found->second;
    }
    return result;
  }

 private:
  std::unordered_map<const TopoDS_TShape*, std::string> labels_;
};

}  // namespace paver
