// With a memory everything is read as without one.
#include "generator/frontend/read/memory.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

bool same(const Span& a, const Span& b) {
  return a.file == b.file && a.line == b.line && a.column == b.column && a.length == b.length;
}

/// Where two trees differ; empty: nowhere.
std::string difference(const YamlValue& a, const YamlValue& b, const std::string& at) {
  if (a.kind != b.kind || a.text != b.text || a.tag != b.tag || a.quoted != b.quoted ||
      a.origin != b.origin || a.with_unit != b.with_unit || !same(a.span, b.span) ||
      a.items.size() != b.items.size() || a.entries.size() != b.entries.size())
    return at + ": " + a.text + " | " + b.text;
  for (std::size_t i = 0; i < a.items.size(); ++i) {
    if (auto found = difference(a.items[i], b.items[i], at + "/" + std::to_string(i));
        !found.empty())
      return found;
  }
  for (std::size_t i = 0; i < a.entries.size(); ++i) {
    const auto &one = a.entries[i], &other = b.entries[i];
    if (one.key != other.key || !same(one.key_span, other.key_span))
      return at + "/" + one.key + "|" + other.key;
    if (auto found = difference(one.value, other.value, at + "/" + one.key); !found.empty())
      return found;
  }
  return {};
}

struct Read {
  YamlValue root;
  std::string text;
};
Read read(const std::string& text) {
  SourceMap sources;
  Diagnostics diagnostics;
  Read result;
  result.root = read_yaml_text("x.yaml", text, sources, diagnostics);
  result.text = render_text(diagnostics, sources, false);
  return result;
}

/// Reads it twice with the memory, for the second time knows it.
void compare(const std::string& text, const std::string& name) {
  const Read plain = read(text);
  const ReadMemory memory;
  for (int i = 0; i < 2; ++i) {
    const Read remembered = read(text);
    EXPECT_EQ(difference(plain.root, remembered.root, name), "");
    EXPECT_EQ(plain.text, remembered.text) << name;
  }
}

std::vector<fs::path> files() {
  std::vector<fs::path> found;
  for (const char* const folder : {"examples", "models", "tests/diagnostics/cases"}) {
    for (const auto& each :
         fs::recursive_directory_iterator(fs::path(EAGERX_SOURCE_DIR) / folder)) {
      if (each.path().extension() == ".yaml" && each.is_regular_file())
        found.push_back(each.path());
    }
  }
  std::ranges::sort(found);
  return found;
}
std::string content(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(ReadMemory, ReadsEveryFileAsWithoutIt) {
  std::size_t count = 0;
  for (const fs::path& path : files()) {
    compare(content(path), path.string());
    ++count;
  }
  EXPECT_GT(count, 300U);
}

TEST(ReadMemory, ReadsOddTextsAsWithoutIt) {
  std::string many = "nodes: # all\n";
  for (int i = 0; i < 30; ++i) many += "  n" + std::to_string(i) + ": {a: [1, 2]} # c\n";
  for (const std::string& text : {std::string(),
                                  std::string("a"),
                                  std::string("a: 1\na: 2\n"),
                                  std::string("a: \"x\nb: y\"\nc: 1\n"),
                                  std::string("a: {b: c,\nd: e}\n"),
                                  std::string("---\na: 1\n"),
                                  std::string("a: 1\n---\nb: 2\n"),
                                  std::string("a: 1\n...\n"),
                                  std::string("a: &x 1\nb: *x\n"),
                                  std::string("a: |\n  b\n  c\nd: e\n"),
                                  std::string("- a\n- b\n"),
                                  std::string("a:\n- b\n- c\nd: 1\n"),
                                  std::string("# only\n"),
                                  std::string("a: b\n c\nd: e\n"),
                                  std::string("a:\n\nb:\n"),
                                  std::string(" a: 1\nb: 2\n"),
                                  many,
                                  many + "  n3: 1\n",
                                  many + "    deeper: 1\n",
                                  many + " less: 1\n",
                                  many + "  - item\n",
                                  many + "  word\n",
                                  many + "  \"quoted\": 1\n",
                                  many + "  n99:\n",
                                  many + "  n98: \"open\nb: c\n",
                                  many + "b:\n- 1\n",
                                  many + "nodes: 2\n",
                                  many + "  n97: |\n    text\n   # more\nz: 1\n"})
    compare(text, text.substr(text.size() > 40 ? text.size() - 40 : 0));
}

TEST(ReadMemory, ReadsWhatSomebodyTypesAsWithoutIt) {
  std::mt19937 random(40);
  std::string text = content(fs::path(EAGERX_SOURCE_DIR) / "examples/quadruped_trot/graph.yaml");
  const std::string letters = "a:-# {}[],'\"\n|&*?0";
  std::vector<Read> plain;
  std::vector<std::string> texts;
  for (int i = 0; i < 400; ++i) {
    const std::size_t at = random() % text.size();
    std::string changed = text;
    if (i % 3 == 0)
      changed.erase(at, 1 + random() % 4);
    else
      changed.insert(at, 1, letters[random() % letters.size()]);
    texts.push_back(changed);
    plain.push_back(read(changed));
    if (plain.back().text.empty()) text = changed;
  }
  const ReadMemory memory;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const Read remembered = read(texts[i]);
    EXPECT_EQ(difference(plain[i].root, remembered.root, std::to_string(i)), "");
    EXPECT_EQ(plain[i].text, remembered.text);
  }
}

}  // namespace
}  // namespace eagerx::gen
