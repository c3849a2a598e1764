// The page that edits: its session, its answers and its files, without a server.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

#include "generator/tools/serve/edit_request.hpp"
#include "generator/tools/serve/graph_file.hpp"
#include "generator/tools/serve/history.hpp"
#include "generator/tools/serve/router.hpp"
#include "generator/tools/serve/session.hpp"
#include "generator/tools/serve/state_json.hpp"

namespace eagerx::gen::serve {
namespace {

namespace fs = std::filesystem;

/// Finds one problem in a text: where it says `thetta`.
class NoWorkshop final : public Workshop {
 public:
  Checked check(const std::string& path, const std::string& text) override {
    Checked checked;
    const FileId file = checked.sources.add(path, text);
    const std::size_t at = text.find("thetta");
    if (at != std::string::npos) {
      const auto line =
          static_cast<std::uint32_t>(std::count(text.begin(), text.begin() + at, '\n'));
      const std::size_t newline = at == 0 ? std::string::npos : text.rfind('\n', at - 1);
      const auto column = static_cast<std::uint32_t>(at - (newline + 1) + 1);
      checked.diagnostics.error("E0307", {file, line + 1, column, 6}, "no `thetta`").help =
          meaning("theta");
    } else {
      checked.page = Json{{"size", text.size()}};
    }
    return checked;
  }
  std::optional<std::string> page(const Json& data, std::string& /*problem*/) override {
    return dump_json(data);
  }
  Json library(const std::string& /*path*/, const std::string& /*text*/) override {
    return Json::object();
  }
  Json schema(const std::string& /*path*/, const std::string& /*text*/) override {
    return Json::object();
  }
  [[nodiscard]] std::string http_module() const override { return {}; }
  [[nodiscard]] std::vector<std::string> self() const override { return {"/bin/echo"}; }
};

class Serve : public testing::Test {
 protected:
  Serve() {
    std::string name = (fs::temp_directory_path() / "serve-test-XXXXXX").string();
    folder_ = mkdtemp(name.data());
  }
  ~Serve() override { fs::remove_all(folder_); }
  [[nodiscard]] std::string graph() const { return (folder_ / "graph.yaml").string(); }
  static std::string text_of_file(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  void save(const std::string& text) const { std::ofstream(graph(), std::ios::binary) << text; }

  fs::path folder_;
  NoWorkshop workshop_;
};

Json edit_of(std::int64_t revision, const std::string& edits) {
  const auto json = parse_json(edits);
  EXPECT_TRUE(json) << edits;
  return Json{{"revision", revision}, {"edits", *json}};
}

TEST_F(Serve, WritesWhereTheExpectedTextIs) {
  GraphFile file(graph());
  EXPECT_FALSE(file.read().exists);
  EXPECT_EQ(file.write("x", "y"), GraphFile::Written::changed);
  EXPECT_EQ(file.write(std::nullopt, "one"), GraphFile::Written::done);
  EXPECT_FALSE(file.may_have_changed());
  EXPECT_EQ(file.write(std::nullopt, "two"), GraphFile::Written::changed);
  EXPECT_EQ(file.write("zero", "two"), GraphFile::Written::changed);
  EXPECT_EQ(text_of_file(graph()), "one");
  EXPECT_EQ(file.write("one", "two"), GraphFile::Written::done);
  EXPECT_EQ(text_of_file(graph()), "two");
  save("tw2");
  EXPECT_TRUE(file.may_have_changed());
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1);
}

TEST_F(Serve, SaysWhatCannotBeReadOrWritten) {
  EXPECT_EQ(GraphFile(folder_.string()).read().problem, "it is a folder");
  EXPECT_EQ(GraphFile("/dev/null").read().problem, "it is not a file");
  GraphFile nowhere((folder_ / "no/graph.yaml").string());
  EXPECT_EQ(nowhere.write(std::nullopt, "x"), GraphFile::Written::failed);
  EXPECT_EQ(nowhere.problem(), "No such file or directory");
  save("one");
  ASSERT_EQ(chmod(graph().c_str(), 0444), 0);
  GraphFile kept(graph());
  EXPECT_EQ(kept.write("one", "two"), GraphFile::Written::failed);
  EXPECT_EQ(kept.problem(), "Permission denied");
  EXPECT_EQ(text_of_file(graph()), "one");
}

TEST_F(Serve, UndoesAndDoesAgain) {
  History history;
  EXPECT_EQ(history.undo_reason() + history.redo_reason(), "");
  EXPECT_EQ(history.undone("a"), "a");
  history.add("abc", difference("one", "abc", "aXc"));
  history.add("aXc", difference("two", "aXc", ""));
  EXPECT_EQ(history.undo_reason(), "two");
  EXPECT_EQ(history.undone(""), "aXc");
  history.step_back();
  EXPECT_EQ(history.undone("aXc"), "abc");
  EXPECT_EQ(history.redone("aXc"), "");
  EXPECT_EQ(history.redo_reason(), "two");
  history.add("aXc", difference("three", "aXc", "aXcd"));
  EXPECT_EQ(history.redo_reason(), "");
  for (std::size_t i = 0; i < 2 * History::kMostSteps; ++i)
    history.add("a", difference("more", "a", "b"));
  std::size_t steps = 0;
  for (; !history.undo_reason().empty(); ++steps) history.step_back();
  EXPECT_EQ(steps, History::kMostSteps);
}

TEST_F(Serve, ForgetsStepsThatAreLargeTogether) {
  History history;
  const std::string large(History::kMostBytes / 4, 'x');
  for (int i = 0; i < 8; ++i) history.add("", difference("large", "", large));
  std::size_t steps = 0;
  for (; !history.undo_reason().empty(); ++steps) history.step_back();
  EXPECT_EQ(steps, 4U);
}

TEST_F(Serve, EditsOnlyTheNewestRevision) {
  save("rate: 1\n");
  Session session(workshop_, graph());
  const char* const faster = R"([{"kind": "set", "path": ["rate"], "value": "2"}])";
  EXPECT_EQ(session.edit(edit_of(7, faster), nullptr).status, 409);
  const Reply done = session.edit(edit_of(1, faster), nullptr);
  EXPECT_EQ(done.status, 200);
  EXPECT_EQ(text_of(member(&done.body, "text")), "rate: 2\n");
  EXPECT_EQ(text_of(member(&done.body, "undo")), "Set `rate`");
  EXPECT_EQ(session.undo(Json{{"revision", 1}}, nullptr).status, 409);
  EXPECT_EQ(session.undo(Json{{"revision", 2}}, nullptr).status, 200);
  EXPECT_EQ(text_of_file(graph()), "rate: 1\n");
  save("rate: 3 # of somebody\n");
  const Reply lost = session.edit(edit_of(3, faster), nullptr);
  EXPECT_EQ(lost.status, 409);
  EXPECT_EQ(text_of(member(member(&lost.body, "state"), "text")), "rate: 3 # of somebody\n");
  EXPECT_EQ(text_of_file(graph()), "rate: 3 # of somebody\n");
  EXPECT_EQ(session.redo(Json{{"revision", 4}}, nullptr).status, 422);
}

// The first request takes the text from the disk; an edit of an older revision is still checked
// against the disk.
TEST_F(Serve, SaysThatTheDiskChangedAlsoAfterAnotherTookIt) {
  save("rate: 1\n");
  Session session(workshop_, graph());
  const char* const faster = R"([{"kind": "set", "path": ["rate"], "value": "2"}])";
  save("rate: 3 # of somebody\n");
  const Reply taken = session.state(std::nullopt, nullptr);
  EXPECT_EQ(number_of(member(&taken.body, "revision")), 2.0);
  const Reply late = session.edit(edit_of(1, faster), nullptr);
  EXPECT_EQ(late.status, 409);
  EXPECT_EQ(text_of(member(&late.body, "error")), "the file was changed on the disk");
  EXPECT_EQ(session.edit(edit_of(2, faster), nullptr).status, 200);
  const Reply older = session.edit(edit_of(2, faster), nullptr);
  EXPECT_EQ(text_of(member(&older.body, "error")), "revision 2 is not the newest one, 3");
}

TEST_F(Serve, ShowsTheLastGoodPage) {
  save("a: 1\n");
  Session session(workshop_, graph());
  Reply state = session.state(std::nullopt, nullptr);
  EXPECT_EQ(number_of(member(member(&state.body, "page"), "size")), 5.0);
  state = session.edit(
      edit_of(1, R"([{"kind": "set", "path": ["b"], "value": "\"🤖 thetta\""}])"), nullptr);
  EXPECT_EQ(number_of(member(member(&state.body, "page"), "size")), 5.0);
  EXPECT_EQ(number_of(member(&state.body, "page_revision")), 1.0);
  EXPECT_EQ(truth_of(member(&state.body, "good")), false);
  const Reply known = session.state(1, nullptr);
  EXPECT_EQ(member(&known.body, "page"), nullptr);
  const Json& problem = member(&state.body, "problems")->as<Json::List>()->front();
  EXPECT_EQ(text_of(member(&problem, "fix")), "Change to `theta`");
  EXPECT_EQ(dump_json(*member(&problem, "path")), "[\n  \"b\"\n]");
}

TEST_F(Serve, CountsPlacesInUtf16) {
  const std::string text = "a: \xF0\x9F\xA4\x96\nb: thetta\n";
  Workshop::Checked checked;
  const FileId file = checked.sources.add("graph.yaml", text);
  checked.diagnostics.error("E0307", {file, 2, 4, 6}, "x");
  const Json problems = problems_json(checked, "graph.yaml", text);
  const Json& problem = problems.as<Json::List>()->front();
  EXPECT_EQ(number_of(member(&problem, "begin")), 9.0);
  EXPECT_EQ(number_of(member(&problem, "end")), 15.0);
}

TEST_F(Serve, OutlinesIncompleteText) {
  const Json outline = outline_json(
      "name: a\nobjects:\n  arm: {type: Arm, sensors: [q]\nnodes:\n  pid:\n    rate: 30\n"
      "observations: [x]\nconnections:\n- {from: arm.q, to: observations.x, delay: {uniform: "
      "{low: 0}}}\n- from: arm");
  const Json& arm = member(&outline, "objects")->as<Json::List>()->front();
  EXPECT_EQ(text_of(member(&arm, "type")), "Arm");
  EXPECT_EQ(text_of(&member(member(&arm, "ports"), "sensors")->as<Json::List>()->front()), "q");
  EXPECT_EQ(member(&outline, "nodes")->as<Json::List>()->size(), 1U);
  const auto& connections = *member(&outline, "connections")->as<Json::List>();
  ASSERT_EQ(connections.size(), 2U);
  EXPECT_EQ(text_of(member(member(&connections[0], "keys"), "delay")), "{uniform: {low: 0}}");
  EXPECT_EQ(text_of(member(&connections[1], "from")), "arm");
}

TEST_F(Serve, AnswersThoseWhoHaveTheToken) {
  save("rate: 1\n");
  Session session(workshop_, graph());
  Programs programs(workshop_.self(), graph());
  const std::string token(32, 'a');
  Router router(session, programs, token, 8080);
  Asked asked{"GET", "/" + token + "/state", "127.0.0.1:8080", "", ""};
  EXPECT_FALSE(router.refusal(asked));
  EXPECT_EQ(router.answer(asked).status, 200);
  const auto status_with = [&](auto change) {
    Asked other = asked;
    change(other);
    const auto refused = router.refusal(other);
    return refused ? refused->status : 200;
  };
  EXPECT_EQ(status_with([](Asked& a) { a.host = "example.org"; }), 403);
  EXPECT_EQ(status_with([](Asked& a) { a.host = ""; }), 403);
  EXPECT_EQ(status_with([](Asked& a) { a.origin = "http://example.org"; }), 403);
  EXPECT_EQ(status_with([](Asked& a) { a.origin = "http://127.0.0.1:8080"; }), 200);
  EXPECT_EQ(status_with([](Asked& a) { a.origin = "null"; }), 403);
  for (const char* const path : {"", "/", "//", "/a/state", "/state", "state", "/aaaa"})
    EXPECT_EQ(status_with([&](Asked& a) { a.path = path; }), 403) << path;
  EXPECT_EQ(status_with([&](Asked& a) { a.path = "/" + token; }), 403);
  EXPECT_EQ(status_with([&](Asked& a) { a.path = "/" + token + "/"; }), 200);
  EXPECT_EQ(status_with([&](Asked& a) { a.path = "/" + token + "/x"; }), 404);
  EXPECT_EQ(status_with([](Asked& a) { a.method = "POST"; }), 405);
  EXPECT_EQ(status_with([](Asked& a) { a.method = "HEAD"; }), 405);
  EXPECT_EQ(status_with([&](Asked& a) {
              a.method = "POST";
              a.path = "/" + token + "/edit";
              a.type = "text/plain";
            }),
            415);
  EXPECT_EQ(router.address(), "http://127.0.0.1:8080/" + token + "/");
}

TEST_F(Serve, RunsOneProgramAndKeepsItsOutput) {
  Programs programs(workshop_.self(), graph());
  EXPECT_EQ(programs.start(Json{{"kind", "explode"}}).status, 400);
  EXPECT_EQ(
      programs
          .start(Json{{"kind", "check"}, {"arguments", Json(std::vector<std::string>{"a b", "c"})}})
          .status,
      200);
  Reply reply;
  do reply = programs.output(0, 0, 10.0);
  while (truth_of(member(&reply.body, "running")) == true);
  const Json& line = member(&reply.body, "lines")->as<Json::List>()->front();
  EXPECT_EQ(text_of(member(&line, "text")), "check " + graph() + " a b c");
  EXPECT_EQ(number_of(member(&reply.body, "exit_code")), 0.0);
  EXPECT_FALSE(programs.result());
}

TEST_F(Serve, UndoGivesTheExamplesBack) {
  constexpr int kEdits = 500;
  std::mt19937 random(1);
  const auto below = [&](std::size_t most) { return random() % most; };
  int made = 0, graphs = 0;
  for (const auto& entry : fs::recursive_directory_iterator(EAGERX_SOURCE_DIR "/examples")) {
    if (entry.path().extension() != ".yaml" || entry.file_size() > 20'000 || ++graphs > 8) continue;
    const std::string first = text_of_file(entry.path().string());
    History history;
    std::string text = first;
    for (int i = 0; i < kEdits; ++i) {
      // A place in it, and what is done there.
      OutlinePath path;
      const OutlineNode top = outline_of(text);
      for (const OutlineNode* node = &top;
           !node->entries.empty() && (path.empty() || below(3) > 0);) {
        const std::size_t index = below(node->entries.size());
        if (node->kind == OutlineNode::Kind::map)
          path.emplace_back(node->entries[index].key);
        else
          path.emplace_back(index);
        node = &node->entries[index].value;
      }
      const std::string name = "new_" + std::to_string(i);
      Change change;
      switch (below(5)) {
        case 0:
          change = set_value(text, path, "[1, {a: b}]");
          break;
        case 1:
          change = remove_entry(text, path);
          break;
        case 2:
          change = add_entry(text, {"nodes", name, "Node", {{"rate", "30"}}});
          break;
        case 3:
          change = connect_ports(text, name + ".x", "b.z", {});
          break;
        default:
          path.emplace_back(name);
          change = set_value(text, path, "7");
      }
      if (!change.edit) continue;
      ++made;
      std::string after = applied(text, change.edit->splices);
      history.add(text, difference(change.edit->reason, text, after));
      text = std::move(after);
    }
    for (; !history.undo_reason().empty(); history.step_back()) text = history.undone(text);
    EXPECT_EQ(text, first) << entry.path();
  }
  EXPECT_EQ(graphs > 8, true);
  EXPECT_GT(made, 8 * kEdits / 2);
}

}  // namespace
}  // namespace eagerx::gen::serve
