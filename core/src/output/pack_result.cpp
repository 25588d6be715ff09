// A result as bytes, from the process that meshed to the one that asked for it.
#include "base/pack_reports.h"
#include "paver/output.h"

namespace paver {

std::string pack_result(const MeshResult& result) {
  Packer packer;
  packer(result);
  return packer.take();
}

MeshResult unpack_result(std::string_view bytes) {
  MeshResult result;
  Unpacker unpacker(bytes);
  unpacker(result);
  return result;
}

}  // namespace paver
