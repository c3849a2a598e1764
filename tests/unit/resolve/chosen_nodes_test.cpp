// How `placement:`, `--split` and `--of` call nodes.
#include "generator/graph/resolve/chosen_nodes.hpp"

#include <gtest/gtest.h>

namespace {

using eagerx::gen::Called;
using eagerx::gen::is_called;

TEST(ChosenNodesTest, ANodeACompositeAnArrayAndPatterns) {
  EXPECT_EQ(is_called("smooth", "smooth"), Called::itself);
  EXPECT_EQ(is_called("smooth_2", "smooth"), Called::no);
  EXPECT_EQ(is_called("arm/smooth", "arm"), Called::inside);
  EXPECT_EQ(is_called("leg[2]", "leg"), Called::itself);
  EXPECT_EQ(is_called("leg[2]", "leg[2]"), Called::itself);
  EXPECT_EQ(is_called("leg[12]", "leg[1]"), Called::no);
  EXPECT_EQ(is_called("leg[2]/knee", "leg"), Called::inside);
  EXPECT_EQ(is_called("leg[2]/knee", "leg[*]"), Called::inside);
  EXPECT_EQ(is_called("leg[2]/knee", "leg[*]/knee"), Called::itself);
  EXPECT_EQ(is_called("leg[12]/knee[3]/pid", "leg[*]/knee"), Called::inside);
  EXPECT_EQ(is_called("leg[2]/hip", "leg[*]/knee"), Called::no);
  EXPECT_EQ(is_called("legs", "leg"), Called::no);
  for (const char* name : {"", "*", "leg[", "leg[]", "leg[*", "/"})
    EXPECT_EQ(is_called("leg[2]/knee", name), Called::no) << name;
}

}  // namespace
