#include "paver/error.h"

#include <gtest/gtest.h>

#include <set>

namespace paver {
namespace {

TEST(Error, SaysWhatToDo) {
  EXPECT_EQ(Error(ErrorCode::bad_option, "size is 'x'; write it like 30.").remedy(), "write it like 30");
  EXPECT_EQ(Error(ErrorCode::internal, "One; two; three").remedy(), "three");
  EXPECT_EQ(Error(ErrorCode::face_failed, "Faces: Face2 (paving: no room; use a smaller size).").remedy(),
            "use a smaller size");
  EXPECT_EQ(Error(ErrorCode::cancelled, "Cancelled; nothing was written.").remedy(), "start again");
}

TEST(Error, EveryCodeHasANameAndARemedyOfItsOwn) {
  std::set<std::string> names;
  for (int code = 0; code <= static_cast<int>(ErrorCode::internal); ++code) {
    Error error(static_cast<ErrorCode>(code), "It failed.");
    EXPECT_NE(error.remedy(), "");
    EXPECT_TRUE(names.insert(code_name(error.code())).second) << code_name(error.code());
  }
}

}  // namespace
}  // namespace paver
