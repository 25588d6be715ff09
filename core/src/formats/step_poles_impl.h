// Faces that hold both poles of their surface, where reading STEP turns them into the disc that is cut out.
#pragma once

#include <XSControl_Reader.hxx>

#include "brep/shape_impl.h"

namespace paver {

/// A file walks along a periodic edge to a pole and back. Where all loops of a face meet its periodic edge, as with a
/// ball that has a rod along its x axis, the reader drops that edge, and the poles with it, and takes the loop for the
/// border of the small piece. Such faces are made anew, on the same surface and with the same edges; their numbers go
/// to `shape.restored`. To be called last: other results of reading then no longer have the shape's faces.
void restore_poles(XSControl_Reader& reader, Shape& shape);

}  // namespace paver
