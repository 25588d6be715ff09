#include "paver/error.h"

#include <gtest/gtest.h>

#include <new>
#include <set>
#include <stdexcept>
#include <system_error>

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

template <class Thrown>
Error said_of(Thrown thrown) {
  try {
    throw thrown;
  } catch (...) {
    return current_error();
  }
}

TEST(Error, IsMadeOfEveryException) {
  EXPECT_EQ(said_of(Error(ErrorCode::no_faces, "None.", {"read", 3, -1, {}})).where().face, 3);
  EXPECT_EQ(said_of(std::bad_alloc()).code(), ErrorCode::out_of_memory);
  EXPECT_EQ(said_of(std::system_error(std::make_error_code(std::errc::resource_unavailable_try_again))).code(),
            ErrorCode::out_of_memory);
  const Error unexpected = said_of(std::runtime_error("no bin 7"));
  EXPECT_STREQ(unexpected.what(), "Internal error (no bin 7); report it with the model.");
  EXPECT_EQ(unexpected.remedy(), "report it with the model");
  EXPECT_EQ(said_of(1).code(), ErrorCode::internal);
}

}  // namespace
}  // namespace paver
