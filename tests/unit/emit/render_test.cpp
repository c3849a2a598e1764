// Templates that cannot be used: an error each, and no text with a hole in it.
#include "generator/backend/emit/render.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace eagerx::gen {
namespace {

using testing::HasSubstr;

class Render : public testing::Test {
 protected:
  ~Render() override { std::filesystem::remove(path_); }

  std::optional<std::string> render(const std::string& text, const View& view) {
    std::ofstream(path_) << text;
    return render_file(path_, "text.hpp", view, diagnostics_);
  }

  void expect_problem(const char* part) {
    ASSERT_EQ(diagnostics_.error_count(), 1U);
    EXPECT_EQ(diagnostics_.all().front().code, "E0501");
    EXPECT_THAT(diagnostics_.all().front().message, HasSubstr(part));
  }

  std::string path_ =
      testing::TempDir() + testing::UnitTest::GetInstance()->current_test_info()->name();
  Diagnostics diagnostics_;
};

TEST_F(Render, PutsValuesIn) {
  View view = object();
  view.set("name", "a<b>");
  EXPECT_EQ(render("{{name}};\n", view), "a<b>;\n");
  EXPECT_FALSE(diagnostics_.has_errors());
}

TEST_F(Render, ATemplateThatIsNotThere) {
  EXPECT_FALSE(render_file(path_ + "/none", "text.hpp", object(), diagnostics_));
  expect_problem("cannot read the template");
  EXPECT_TRUE(diagnostics_.has_io_errors());
}

TEST_F(Render, ASectionThatIsNotClosed) {
  EXPECT_FALSE(render("{{#nodes}}\n", object()));
  expect_problem("is wrong");
}

TEST_F(Render, ANameWithoutAValue) {
  EXPECT_FALSE(render("{{nmae}}\n", object()));
  expect_problem("`nmae`");
}

}  // namespace
}  // namespace eagerx::gen
