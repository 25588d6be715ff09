// Measured on plates and wings of 10 000 to 500 000 elements: the largest use of memory follows the elements.
#include "sizing/predicted_memory.h"

namespace paver {
namespace {

constexpr double base_mib = 10;
constexpr double bytes_per_element_order_1 = 1200, bytes_per_element_order_2 = 2000;

}  // namespace

double predicted_memory_mib(double elements, const Options& options) {
  double bytes = options.order == 1 ? bytes_per_element_order_1 : bytes_per_element_order_2;
  return base_mib + elements * bytes / (1024 * 1024);
}

}  // namespace paver
