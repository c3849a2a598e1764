#include "generator/support/diagnostics/pages.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "generator/support/diagnostics/diagnostics.hpp"

namespace eagerx::gen {
namespace {

TEST(Pages, AreSortedAndHaveATitle) {
  const auto pages = code_pages();
  ASSERT_FALSE(pages.empty());
  for (const CodePage& page : pages) {
    EXPECT_FALSE(page.title().empty()) << page.code;
    EXPECT_EQ(page.text.find(page.title()), std::string_view("# E0000: ").size()) << page.code;
  }
  EXPECT_TRUE(std::is_sorted(pages.begin(), pages.end(),
                             [](const auto& a, const auto& b) { return a.code < b.code; }));
}

TEST(Pages, AreNamedForErrorsOnceEach) {
  Diagnostics diagnostics;
  EXPECT_EQ(pointer_to_pages(diagnostics), "");
  diagnostics.note({}, "a note");
  diagnostics.warning("E0706", {}, "a warning");
  EXPECT_EQ(pointer_to_pages(diagnostics), "");
  diagnostics.error("E0310", {}, "one");
  diagnostics.error("E0310", {}, "the same");
  EXPECT_EQ(pointer_to_pages(diagnostics),
            "`eagerx-gen explain E0310` says more about this error\n");
  diagnostics.error("E0307", {}, "another");
  EXPECT_EQ(pointer_to_pages(diagnostics),
            "`eagerx-gen explain CODE` says more about each of E0307, E0310\n");
}

}  // namespace
}  // namespace eagerx::gen
