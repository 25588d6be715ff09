#include "base/tasks/gather.h"

#include <gtest/gtest.h>

#include "support/thread_ranks.h"

namespace paver {
namespace {

TEST(DoTogether, ThrowsTheWholeErrorOfTheLowestRankThatFails) {
  std::vector<Error> thrown(3, Error(ErrorCode::internal, ""));
  test::run_on_ranks(3, [&](Ranks& ranks) {
    try {
      do_together(ranks, [&] {
        if (ranks.rank() > 0) throw Error(ErrorCode::no_faces, "No.", {"read", ranks.rank(), 5, Vec3{1, 2, 3}});
      });
    } catch (const Error& error) {
      thrown[ranks.rank()] = error;
    }
  });
  for (const Error& error : thrown) {
    EXPECT_EQ(error.code(), ErrorCode::no_faces);
    EXPECT_STREQ(error.what(), "No.");
    EXPECT_EQ(error.where().stage, "read");
    EXPECT_EQ(error.where().face, 1);
    EXPECT_EQ(error.where().edge, 5);
    EXPECT_EQ(error.where().point, (Vec3{1, 2, 3}));
  }
}

}  // namespace
}  // namespace paver
