// Templates that include others.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "generator/backend/emit/render.hpp"

namespace eagerx::gen {
namespace {

class Templates {
 public:
  Templates()
      : folder_(std::filesystem::temp_directory_path() /
                ("eagerx-gen-render-test." + std::to_string(getpid()))) {
    std::filesystem::create_directories(folder_);
  }
  ~Templates() { std::filesystem::remove_all(folder_); }
  Templates(const Templates&) = delete;
  Templates& operator=(const Templates&) = delete;

  void file(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / (name + ".mustache")) << text;
  }
  /// The text of a template, or its one problem.
  std::string rendered(const std::string& name, const View& view) const {
    Diagnostics diagnostics;
    const auto text =
        render_file((folder_ / (name + ".mustache")).string(), "text.txt", view, diagnostics);
    EXPECT_EQ(diagnostics.error_count(), text ? 0U : 1U);
    if (text) return *text;
    EXPECT_EQ(diagnostics.all().front().code, "E0501");
    return diagnostics.all().front().message;
  }

 private:
  std::filesystem::path folder_;
};

View view_of_items() {
  View items = list();
  for (const char* name : {"a", "b"}) {
    View item = object();
    item.set("name", name);
    items.push_back(item);
  }
  View view = object();
  view["items"] = std::move(items);
  view.set("indented", indented());
  return view;
}

TEST(TemplateFiles, ATagAloneOnItsLineLeavesNoLine) {
  const Templates templates;
  templates.file("all", "{\n  {{#items}}\n  {{name}};\n\n  {{/items}}\n}\n");
  EXPECT_EQ(templates.rendered("all", view_of_items()), "{\n  a;\n\n  b;\n\n}\n");
}

TEST(TemplateFiles, TemplatesIncludeThoseNextToThem) {
  const Templates templates;
  templates.file("all", "{\n{{#items}}\n{{>one}}\n{{/items}}\n}\n");
  templates.file("one", "  {{name}};\n{{>two}}\n");
  templates.file("two", "  // {{name}}\n");
  EXPECT_EQ(templates.rendered("all", view_of_items()), "{\n  a;\n  // a\n  b;\n  // b\n}\n");
}

TEST(TemplateFiles, IndentsASection) {
  const Templates templates;
  templates.file("all",
                 "{\n{{#indented}}\n{{#items}}\n  {{name}};\n\n{{/items}}\n{{/indented}}\n}\n");
  EXPECT_EQ(templates.rendered("all", view_of_items()), "{\n    a;\n\n    b;\n\n}\n");
}

TEST(TemplateFiles, WhatIsNotThereIsAnError) {
  const Templates templates;
  const auto says = [&](const char* name, const char* what) {
    return templates.rendered(name, view_of_items()).find(what) != std::string::npos;
  };
  templates.file("includes", "{{>nothing}}\n");
  EXPECT_TRUE(says("includes", "nothing.mustache"));
  templates.file("endless", "{{>endless}}\n");
  EXPECT_TRUE(says("endless", "includes itself"));
}

}  // namespace
}  // namespace eagerx::gen
