#include "paver/breakdown.h"

#include <gtest/gtest.h>

namespace paver {
namespace {

TEST(Breakdown, ARefusalIsReadFromTheOutputOfATrial) {
  const Error refusal(ErrorCode::no_faces, "'a.step' has no faces; export surfaces.");
  const auto heard = refusal_in("what the kernel prints\n" + refusal_text(refusal));
  ASSERT_TRUE(heard);
  EXPECT_EQ(heard->code(), refusal.code());
  EXPECT_STREQ(heard->what(), refusal.what());
}

TEST(Breakdown, OutputWithoutARefusalIsNone) {
  for (const char* output : {"", "topology\n", "\x1e",
                             "\x1e"
                             "3"})
    EXPECT_FALSE(refusal_in(output)) << output;
}

}  // namespace
}  // namespace paver
