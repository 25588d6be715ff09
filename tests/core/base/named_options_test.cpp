#include "base/options/named_options.h"

#include <gtest/gtest.h>

#include "paver/error.h"
#include "paver/option_table.h"

namespace paver {
namespace {

Options with(std::vector<GivenOption> given) {
  given.insert(given.begin(), {"frequency", "3GHz"});
  return read_options(given);
}

TEST(NamedOptions, AddUpAndKeepWhatIsSaid) {
  Options options = with({{"medium", "FR4=Solid1,Solid3,eps-r:4.4,tan-d:0.02"},
                          {"medium", "Metal=Solid2,conductor"},
                          {"port", "Feed=Edge5,Face3,Vertex1"},
                          {"wire", "Mast=Edge7,radius:0.1in"}});
  check(options);
  ASSERT_EQ(options.media.size(), 2u);
  EXPECT_EQ(options.media[0].eps_r, 4.4);
  EXPECT_EQ(options.media[0].loss_tangent, 0.02);
  EXPECT_TRUE(options.media[1].is_conductor);
  EXPECT_EQ(options.ports.at(0).parts, (std::vector<std::string>{"Edge5", "Face3", "Vertex1"}));
  EXPECT_DOUBLE_EQ(options.wires.at(0).radius, 2.54);
}

TEST(NamedOptions, RefuseWhatCannotBe) {
  using List = std::vector<GivenOption>;
  for (const List& given : {List{{"medium", "FR4"}}, List{{"medium", "FR4=Solid1,eps:4"}},
                            List{{"medium", "FR4=Solid1,eps-r:x"}}, List{{"medium", "FR4=Solid1,eps-r:4,eps-r:5"}},
                            List{{"port", "Feed=Edge1,radius:1"}}, List{{"wire", "Mast=Edge1,radius:wide"}}})
    EXPECT_THROW(with(given), Error) << given[0].second;
  for (const List& given :
       {List{{"medium", "=Solid1"}}, List{{"medium", "FR4="}}, List{{"medium", "FR4=Face1"}},
        List{{"medium", "FR4=Solid1,eps-r:0"}}, List{{"medium", "FR4=Solid1,tan-d:-1"}},
        List{{"medium", "A=Solid1"}, {"medium", "B=Solid1"}}, List{{"port", "Face2=Face1"}},
        List{{"medium", "A=Solid1,eps-r:4"}, {"medium", "A=Solid2,eps-r:9"}},
        List{{"port", "A=Edge1"}, {"wire", "A=Edge2,radius:1"}}, List{{"port", "Feed=Solid1"}},
        List{{"port", "Feed=nose"}}, List{{"wire", "Mast=Edge1"}}, List{{"wire", "Mast=Face1,radius:1"}},
        List{{"port", "A=Edge1"}, {"wire", "B=Edge1,radius:1"}}})
    EXPECT_THROW(check(with(given)), Error) << given[0].second;
}

TEST(NamedOptions, PartsOfOneNameAddUpWhereTheSameIsSaidOfThem) {
  check(
      with({{"medium", "A=Solid1,eps-r:4"}, {"medium", "A=Solid2,eps-r:4"}, {"port", "P=Edge1"}, {"port", "P=Edge2"}}));
}

TEST(NamedOptions, MediaGiveTheirSolidsTheWavelengthWhereItIsShorter) {
  const Options options = with({{"medium", "Dense=Solid1,eps-r:4"},
                                {"medium", "Air=Solid2"},
                                {"medium", "Metal=Solid3,eps-r:9,conductor"},
                                {"medium", "Lossy=Solid4,eps-r:4,tan-d:1"}});
  const std::vector<LocalSize> lengths = lengths_in_media(options);
  ASSERT_EQ(lengths.size(), 2u);
  EXPECT_EQ(lengths[0].part, "Solid1");
  EXPECT_NEAR(local_length(options, lengths[0]), target_length(options) / 2, 1e-12);
  EXPECT_LT(local_length(options, lengths[1]), local_length(options, lengths[0])) << "losses shorten it";
  Options by_size = options;
  by_size.frequency.reset();
  by_size.size = 5;
  EXPECT_TRUE(lengths_in_media(by_size).empty());
}

}  // namespace
}  // namespace paver
