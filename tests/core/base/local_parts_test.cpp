#include "base/local_parts.h"

#include <gtest/gtest.h>

namespace paver {
namespace {

TEST(ParsePart, TakesNamesWithANumberFromOne) {
  for (auto [text, kind, index] :
       {std::tuple{"Face3", PartKind::face, 2}, std::tuple{"Edge12", PartKind::edge, 11},
        std::tuple{"Vertex1", PartKind::vertex, 0}, std::tuple{"Solid2", PartKind::solid, 1}}) {
    auto part = parse_part(text);
    ASSERT_TRUE(part) << text;
    EXPECT_EQ(part->kind, kind) << text;
    EXPECT_EQ(part->index, index) << text;
  }
  for (const char* bad : {"", "Face", "Face0", "Face-1", "face3", "Face3x", "Face 3", "Shell1", "3", "Face99999999999"})
    EXPECT_FALSE(parse_part(bad)) << bad;
}

TEST(ParseLocal, ReadsLengthsAndMediaForOneOrMoreParts) {
  auto list = parse_local("Face3 = 2 mm; Edge5,Vertex2=0.1in;Solid1=eps-r:4,mu_r:1.5");
  ASSERT_TRUE(list);
  ASSERT_EQ(list->size(), 4u);
  EXPECT_EQ((*list)[0].part, "Face3");
  EXPECT_EQ((*list)[0].size, 2);
  EXPECT_EQ((*list)[1].part, "Edge5");
  EXPECT_EQ((*list)[2].part, "Vertex2");
  EXPECT_DOUBLE_EQ((*list)[2].size.value(), 2.54);
  EXPECT_FALSE((*list)[3].size);
  EXPECT_EQ((*list)[3].eps_r, 4);
  EXPECT_EQ((*list)[3].mu_r, 1.5);
}

TEST(ParseLocal, RefusesOtherText) {
  for (const char* bad : {"", "Face3", "Face3=", "Face3=two", "Face3=eps:4", "Face3=eps-r:", "Face3=2;", "Face3=4 GHz"})
    EXPECT_FALSE(parse_local(bad)) << bad;
}

TEST(ParseNamed, TakesPartsFlagsAndFactsBehindTheLastEqualsSign) {
  auto named = parse_named("a = b, c=Solid1 , conductor,mu_r: 2", {"conductor"});
  ASSERT_TRUE(named);
  EXPECT_EQ(named->name, "a = b, c");
  EXPECT_EQ(named->parts, std::vector<std::string>{"Solid1"});
  using Facts = std::vector<std::pair<std::string, std::string>>;
  EXPECT_EQ(named->facts, (Facts{{"conductor", ""}, {"mu-r", "2"}}));
  EXPECT_FALSE(parse_named("Solid1", {}));
}

}  // namespace
}  // namespace paver
