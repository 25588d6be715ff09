#include "base/tasks/gather.h"

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

std::string pack_error(const Error& error) {
  const auto& [stage, face, edge, point] = error.where();
  Packer packer;
  packer(error.code(), std::string(error.what()), stage, face, edge, point);
  return packer.take();
}

void throw_packed(std::string_view bytes) {
  ErrorCode code = ErrorCode::internal;
  std::string text;
  Where where;
  Unpacker unpacker(bytes);
  unpacker(code, text, where.stage, where.face, where.edge, where.point);
  throw Error(code, text, where);
}

void do_together(Ranks& ranks, const std::function<void()>& work) {
  if (ranks.count() == 1) return work();
  std::string mine;  // empty: done
  try {
    work();
  } catch (const Error& error) {
    mine = pack_error(error);
  }
  for (const std::string& fault : ranks.gather(mine))
    if (!fault.empty()) throw_packed(fault);
}

}  // namespace paver
