// Numbers of all ranks brought together.
#pragma once

#include <vector>

#include "paver/ranks.h"
#include "quality/exact_sum.h"

namespace paver {

class Reduction {
 public:
  void sum(long& value) { longs_.push_back(&value); }
  void sum(ExactSum& value) { sums_.push_back(&value); }
  void least(double& value) { least_.push_back(&value); }

  /// Collective: every number named becomes that of all ranks.
  void run(Ranks& ranks) {
    std::vector<long> numbers;
    for (long* value : longs_) numbers.push_back(*value);
    for (ExactSum* value : sums_) {
      for (long part : value->parts()) numbers.push_back(part);
    }
    ranks.add_up(numbers);
    const long* at = numbers.data();
    for (long* value : longs_) *value = *at++;
    for (ExactSum* value : sums_) value->set_parts(at), at += ExactSum::part_count;
    std::vector<double> least;
    for (double* value : least_) least.push_back(*value);
    ranks.find_least(least);
    for (std::size_t i = 0; i < least.size(); ++i) *least_[i] = least[i];
  }

 private:
  std::vector<long*> longs_;
  std::vector<ExactSum*> sums_;
  std::vector<double*> least_;
};

}  // namespace paver
