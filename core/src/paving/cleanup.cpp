#include "paving/cleanup.h"
#include "paving/smooth.h"
namespace paver {
void clean_up(Front& front, const Progress& progress) {
  std::vector<int> nodes;
  for (int i = 0; i < front.mesh.node_count(); ++i) nodes.push_back(i);
  for (int k = 0; k < 6; ++k) {
    progress.check();
    smooth_nodes(front, nodes, 1);
  }
}
}  // namespace paver
