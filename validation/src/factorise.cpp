// Compiled for several kinds of processors, each in a namespace PAVER_KIND of its own. Eigen is renamed with it, for
// the linker not to take code of one kind for that of another.
#include <Eigen/LU>
#include <complex>

namespace paver::validation::PAVER_KIND {

void factorise(std::complex<double>* matrix, long rows, int* places) {
  using Rows = Eigen::Matrix<std::complex<double>, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  Eigen::Map<Rows> all(matrix, rows, rows);
  const Eigen::PartialPivLU<Eigen::Ref<Rows>> factors(all);
  for (long i = 0; i < rows; ++i) places[i] = static_cast<int>(factors.permutationP().indices()[i]);
}

}  // namespace paver::validation::PAVER_KIND
