#include "base/tasks/gather.h"

#include "paver/error.h"

namespace paver {

double greatest(double mine, Ranks& ranks) {
  double value = -mine;
  ranks.find_least({&value, 1});
  return -value;
}

void unite(std::vector<Box>& boxes, Ranks& ranks) {
  std::vector<double> values;
  for (const auto& [low, high] : boxes)
    for (double value : {low.x, low.y, low.z, -high.x, -high.y, -high.z}) values.push_back(value);
  ranks.find_least(values);
  const double* at = values.data();
  for (Box& box : boxes) box = {{at[0], at[1], at[2]}, {-at[3], -at[4], -at[5]}}, at += 6;
}

void do_together(Ranks& ranks, const std::function<void()>& work) {
  if (ranks.count() == 1) return work();
  std::string mine;  // empty: done; else the code and the sentence
  try {
    work();
  } catch (const Error& error) {
    mine = static_cast<char>(error.code()) + std::string(error.what());
  }
  for (const std::string& fault : ranks.gather(mine)) {
    if (!fault.empty()) throw Error(static_cast<ErrorCode>(fault[0]), fault.substr(1));
  }
}

}  // namespace paver
