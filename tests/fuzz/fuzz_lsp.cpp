// Input from an editor: the outline of an incomplete text with a cursor at any place, and the
// protocol. Input: the text of a graph, or, from a first byte 0xff on, bytes of the stream.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "generator/frontend/outline/fixes.hpp"
#include "generator/tools/edit/rename_port.hpp"
#include "generator/tools/lsp/complete.hpp"
#include "generator/tools/lsp/fold.hpp"
#include "generator/tools/lsp/server.hpp"
#include "generator/tools/lsp/stream.hpp"

namespace {

using namespace eagerx::gen;

/// Knows two keys, and finds nothing wrong.
class StubAnalyst final : public lsp::Analyst {
 public:
  Checked check(const std::string& /*path*/, const std::string& /*text*/) override { return {}; }
  const lsp::LibraryFacts& of_graph(const std::string& /*path*/,
                                    const std::string& /*text*/) override {
    return facts_;
  }
  const lsp::LibraryFacts& of_manifests() override { return facts_; }
  Checked try_out(const std::string& /*path*/, const std::string& /*text*/) override { return {}; }
  std::shared_ptr<const lsp::Resolved> resolved(const std::string& /*path*/) override {
    return resolved_;
  }
  std::optional<EntityFiles> files_of(const std::string& /*path*/, const std::string& /*text*/,
                                      const std::string& /*id*/) override {
    return EntityFiles{"/manifest.yaml", "/b.hpp", true};
  }
  std::vector<std::string> own_manifests(const std::string& /*path*/,
                                         const std::string& /*text*/) override {
    return {"/manifest.yaml"};
  }
  [[nodiscard]] std::vector<std::string> folders() const override { return {"/"}; }
  void set_text(const std::string& path, std::optional<std::string> text) override {
    if (text)
      texts_[path] = std::move(*text);
    else
      texts_.erase(path);
  }
  std::optional<std::string> text_of(const std::string& path) override {
    const auto found = texts_.find(path);
    return found != texts_.end() ? found->second : kManifest;
  }
  void forget() override {}

 private:
  const lsp::LibraryFacts facts_{
      *parse_json(
          R"({"properties":{"a":{"type":"object","description":"x","additionalProperties":{"properties":{"type":{"enum":["b","c"]}}}},
          "connections":{"items":{"properties":{"from":{},"to":{}}}}}})"),
      {{"b", {"goal"}}}};
  const std::string kManifest = "id: b\ninputs:\n  in: {space: {like: in}}\n";
  const std::shared_ptr<const lsp::Resolved> resolved_ = std::make_shared<const lsp::Resolved>(
      lsp::Resolved{{{"x.in", {"1 a tick", "1 ms", "", "about"}}},
                    {{"x.in", "p"}},
                    {{"x", "o"}},
                    {{"x", "1 Hz"}}});
  std::map<std::string, std::string> texts_;
};

/// Splices lie in the text, and a help of a diagnostic anywhere can be applied.
void edits(const std::string& text, std::size_t at) {
  Diagnostic problem;
  problem.code = "E0203";
  problem.span = {static_cast<FileId>(0), static_cast<std::uint32_t>(at % 7),
                  static_cast<std::uint32_t>(at % 11), static_cast<std::uint32_t>(at % 5)};
  problem.message = "`x.in` is wrong";
  for (const Fix& fix :
       {change_to("a"), change_number_to("1"), change_list_to("1"), leave_out(""), add_key("rate"),
        add_key("n"), add_to_connection("processor", "A"), add_parameter("n"),
        missing_connection("{from: …, to: x.in}").fixes.front(), add_to_list("x", "inputs", "x"),
        skip_at({}, "a", "b"), allow_here("W0115"), set_in_graph("rate", "1")}) {
    problem.help = {"", fix};
    for (const TextFix& each : fixes_of(problem, text)) {
      for (const Splice& splice : each.edit.splices) {
        if (splice.place.begin > splice.place.end || splice.place.end > text.size()) std::abort();
      }
      applied(text, each.edit.splices);
    }
  }
  if (const auto port = port_in_graph(text, at)) {
    uses_of_port(text, port->type, port->port);
    uses_of_port_in_manifest(text, port->type, port->port);
  }
  port_in_manifest(text, at);
  uses_of_port_in_header(text, "in");
  for (const auto& fold : lsp::folds_of(text)) {
    if (fold.first >= fold.last) std::abort();
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view input(reinterpret_cast<const char*>(data), size);
  static StubAnalyst analyst;
  if (size > 0 && data[0] == 0xff) {
    lsp::Server server(analyst);
    lsp::MessageReader reader;
    reader.add(input.substr(1));
    server.take(R"({"method":"initialize","id":1})");
    while (const auto content = reader.next()) server.take(*content);
    server.check_changed();
    server.take_answers();
    return 0;
  }
  const std::string text(input);
  const std::size_t at = size == 0 ? 0 : data[size - 1] * size / 255;
  const Cursor cursor = cursor_at(text, at);
  if (cursor.word.begin > at || cursor.word.end < at || cursor.word.end > size) std::abort();
  lsp::complete(analyst.of_graph({}, {}), text, at);
  lsp::complete(analyst.of_graph({}, {}), text, at, true);
  lsp::hover(analyst.of_graph({}, {}), text, at, analyst.resolved({}).get());
  for (const auto& hint : lsp::inlay_hints(outline_of(text), *analyst.resolved({}), {0, size})) {
    if (hint.at > size) std::abort();
  }
  edits(text, at);
  return 0;
}
