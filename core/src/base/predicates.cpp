// The exact branch of orientation(): the determinant as a sum of six exact products, added without rounding
// as an expansion of non-overlapping terms [Shewchuk97].
#include "base/predicates.h"

namespace paver::detail {
namespace {

struct Pair {
  double high, low;  // high + low is the exact value
};

Pair exact_sum(double a, double b) {
  double s = a + b, bb = s - a;
  return {s, (a - (s - bb)) + (b - bb)};
}

Pair exact_product(double a, double b) {
  double p = a * b;
  return {p, std::fma(a, b, -p)};
}

/// Sum of doubles kept exactly: terms grow in size and do not overlap.
class Expansion {
 public:
  void add(double value) {
    int kept = 0;
    for (int i = 0; i < size_; ++i) {
      Pair s = exact_sum(value, term_[i]);
      if (s.low != 0) term_[kept++] = s.low;
      value = s.high;
    }
    term_[kept++] = value;
    size_ = kept;
  }
  double sign() const {
    for (int i = size_ - 1; i >= 0; --i)
      if (term_[i] != 0) return term_[i];
    return 0;
  }

 private:
  double term_[16];
  int size_ = 0;
};

}  // namespace

double exact_orientation(Vec2 a, Vec2 b, Vec2 c) {
  Expansion sum;
  const Pair products[6] = {exact_product(a.x, b.y),  exact_product(-a.y, b.x), exact_product(b.x, c.y),
                            exact_product(-b.y, c.x), exact_product(c.x, a.y),  exact_product(-c.y, a.x)};
  for (const Pair& p : products) {
    sum.add(p.low);
    sum.add(p.high);
  }
  return sum.sign();
}

}  // namespace paver::detail
