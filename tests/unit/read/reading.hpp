// Shared by the tests of read/.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "generator/frontend/read/tree.hpp"
#include "generator/support/diagnostics/diagnostics.hpp"

namespace eagerx::gen {

/// The outcome of reading a text.
struct Reading {
  SourceMap sources;
  Diagnostics diagnostics;
  YamlValue root;

  explicit Reading(std::string text, Tags tags = Tags::refuse, const ReadLimits& limits = {})
      : root(read_yaml_text("in.yaml", std::move(text), sources, diagnostics, tags, limits)) {}
  [[nodiscard]] std::string report() const { return render_text(diagnostics, sources, false); }
};

/// "line:column+length"
inline std::string place(const Span& span) {
  return std::to_string(span.line) + ":" + std::to_string(span.column) + "+" +
         std::to_string(span.length);
}

/// The tree on one line: kind, text and place of every node, keys with their places.
inline std::string show(const YamlValue& yaml) {
  std::string result = place(yaml.span);
  if (!yaml.tag.empty()) result += " <" + yaml.tag + ">";
  if (yaml.is_null()) return result + " null";
  if (yaml.is_scalar())
    return result + (yaml.quoted ? " \"" : " ") + yaml.text + (yaml.quoted ? "\"" : "");
  result += yaml.is_map() ? " {" : " [";
  const char* separator = "";
  for (const YamlValue& item : yaml.items) {
    result += separator + show(item);
    separator = ", ";
  }
  for (const YamlValue::Entry& entry : yaml.entries) {
    result += separator + place(entry.key_span) + " " + entry.key + ": " + show(entry.value);
    separator = ", ";
  }
  return result + (yaml.is_map() ? "}" : "]");
}

/// The text has no problem, and this tree.
inline void expect_tree(const std::string& text, const std::string& tree,
                        Tags tags = Tags::refuse) {
  const Reading reading(text, tags);
  EXPECT_EQ(reading.report(), "") << text;
  EXPECT_EQ(show(reading.root), tree) << text;
}

/// The first problem of the text; all are errors and nothing is returned.
inline void expect_error(const std::string& text, const std::string& code, const std::string& where,
                         const std::string& message, const ReadLimits& limits = {}) {
  const Reading reading(text, Tags::refuse, limits);
  const std::string shown = text.substr(0, 200);
  ASSERT_TRUE(reading.diagnostics.has_errors()) << shown;
  EXPECT_TRUE(reading.root.is_null()) << shown;
  const Diagnostic& error = reading.diagnostics.all().front();
  EXPECT_EQ(error.code, code) << shown << '\n' << reading.report();
  EXPECT_EQ(place(error.span), where) << shown << '\n' << reading.report();
  EXPECT_NE(error.message.find(message), std::string::npos) << shown << '\n' << reading.report();
  EXPECT_FALSE(error.io);
}

}  // namespace eagerx::gen
