#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "generator/support/diagnostics/diagnostics.hpp"

namespace eagerx::gen {
namespace {

TEST(RenderJson, EveryFieldInStableOrder) {
  SourceMap sources;
  const FileId file = sources.add("a.yaml", "x: 1");
  Diagnostics diagnostics;
  Diagnostic& error = diagnostics.error("E1", {file, 2, 3, 4}, "say \"hi\"\n");
  error.label = "l";
  error.notes.push_back({"n", {}, "nl"});
  error.help = {"h", change_to("x")};
  EXPECT_EQ(render_json(diagnostics, sources), R"([
  {
    "severity": "error",
    "code": "E1",
    "message": "say \"hi\"\n",
    "span": {
      "file": "a.yaml",
      "line": 2,
      "column": 3,
      "length": 4
    },
    "label": "l",
    "notes": [
      {
        "message": "n",
        "span": null,
        "label": "nl"
      }
    ],
    "help": "h",
    "fixes": [
      {
        "title": "Change to `x`",
        "certain": true,
        "edits": [
          {
            "span": {
              "file": "a.yaml",
              "line": 2,
              "column": 3,
              "length": 4
            },
            "text": "x"
          }
        ]
      }
    ],
    "io": false
  }
]
)");
}

TEST(RenderJson, NothingIsAnEmptyArray) {
  EXPECT_EQ(render_json(Diagnostics(), SourceMap()), "[]\n");
}

TEST(RenderJson, StaysValidWithBytesThatAreNotUtf8) {
  SourceMap sources;
  const FileId file = sources.add("\xff\x01.yaml", "");
  Diagnostics diagnostics;
  diagnostics.io_error("E1", {file, 0, 0, 0}, "cannot read `\xff`");
  diagnostics.warning("E2", {}, "w");
  const auto parsed = nlohmann::json::parse(render_json(diagnostics, sources));
  ASSERT_EQ(parsed.size(), 2U);
  EXPECT_EQ(parsed[0]["span"]["file"], "\xef\xbf\xbd\x01.yaml");
  EXPECT_EQ(parsed[0]["io"], true);
  EXPECT_EQ(parsed[1]["severity"], "warning");
  EXPECT_TRUE(parsed[1]["span"].is_null());
}

}  // namespace
}  // namespace eagerx::gen
