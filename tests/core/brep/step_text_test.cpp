// What the text of a STEP file says of its entities' names.
#include <gtest/gtest.h>

#include "brep/reading/texts.h"

namespace paver {
namespace {

TEST(StepText, EveryEntityIsThereOnce) {
  const StepNames names = find_step_names("DATA;\n#1=A('#3 = no entity',#2);\n/* #2=OLD(); */ #2 = B($);\nENDSEC;");
  EXPECT_EQ(names.doubled, 0U);
  EXPECT_TRUE(names.is_whole);
  EXPECT_FALSE(names.has_scopes);
}

TEST(StepText, FindsWhatIsMissingAndWhatIsThereTwice) {
  EXPECT_FALSE(find_step_names("#1=A(#2);").is_whole);
  EXPECT_EQ(find_step_names("#1=A(#9,#2,#3);#2=B(#9);").missing, (std::vector<std::uint64_t>{3, 9}));
  EXPECT_FALSE(find_step_names("#=A();").is_whole);
  EXPECT_EQ(find_step_names("#9=A();#7=B();#9=C();#7=D();").doubled, 7U);
}

TEST(StepText, KnowsScopes) { EXPECT_TRUE(find_step_names("#1=&SCOPE #2=A(); ENDSCOPE B(#2);").has_scopes); }

}  // namespace
}  // namespace paver
