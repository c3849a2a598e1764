// What an editor sends: the outline of a half-written text with a cursor at any place, and the
// protocol. Input: the text of a graph, or, from a first byte 0xff on, bytes of the stream.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "generator/lsp/complete.hpp"
#include "generator/lsp/server.hpp"
#include "generator/lsp/stream.hpp"

namespace {

using namespace eagerx::gen;

/// Knows two keys, and finds nothing wrong.
class Nobody final : public lsp::Analyst {
 public:
  Checked check(const std::string& /*path*/, const std::string& /*text*/) override { return {}; }
  const lsp::LibraryFacts& of_graph(const std::string& /*path*/,
                                    const std::string& /*text*/) override {
    return facts_;
  }
  const lsp::LibraryFacts& of_manifests() override { return facts_; }
  std::string manifest_of(const std::string& /*path*/, const std::string& /*text*/,
                          const std::string& /*id*/) override {
    return "/manifest.yaml";
  }
  void forget() override {}

 private:
  const lsp::LibraryFacts facts_{
      *parse_json(
          R"({"properties":{"a":{"type":"object","description":"x","additionalProperties":{"properties":{"type":{"enum":["b","c"]}}}},
          "connections":{"items":{"properties":{"from":{},"to":{}}}}}})"),
      {{"b", {"goal"}}}};
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view input(reinterpret_cast<const char*>(data), size);
  static Nobody nobody;
  if (size > 0 && data[0] == 0xff) {
    lsp::Server server(nobody);
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
  lsp::complete(nobody.of_graph({}, {}), text, at);
  lsp::hover(nobody.of_graph({}, {}), text, at);
  return 0;
}
