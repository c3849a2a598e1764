// Streams and positions; what the server answers is in tests/lsp.
#include <gtest/gtest.h>

#include "generator/support/files/uri.hpp"
#include "generator/tools/lsp/stream.hpp"
#include "generator/tools/lsp/text.hpp"

namespace eagerx::gen::lsp {
namespace {

TEST(LspStream, TakesMessagesInPieces) {
  MessageReader reader;
  const std::string all = message_of("{\"a\":1}") + "content-length:2\r\nContent-Type: x\r\n\r\n{}";
  std::vector<std::string> found;
  for (const char c : all) {
    reader.add(std::string(1, c));
    while (auto next = reader.next()) found.push_back(*next);
  }
  EXPECT_EQ(found, (std::vector<std::string>{"{\"a\":1}", "{}"}));
  EXPECT_FALSE(reader.is_broken());
}

TEST(LspStream, EndsAtWhatIsNoMessage) {
  for (const char* const text :
       {"GET / HTTP/1.1\r\n\r\n", "Content-Length: -1\r\n\r\n", "Content-Length: 1x\r\n\r\n",
        "Content-Length: 99999999999999999999\r\n\r\n", "Content-Length: 67108865\r\n\r\n",
        "\r\n\r\n"}) {
    MessageReader reader;
    reader.add(text);
    EXPECT_EQ(reader.next(), std::nullopt) << text;
    EXPECT_TRUE(reader.is_broken()) << text;
  }
  MessageReader reader;
  reader.add(std::string(MessageReader::kMostHeader, 'x'));
  EXPECT_EQ(reader.next(), std::nullopt);
  EXPECT_FALSE(reader.is_broken());
  reader.add("x");
  EXPECT_EQ(reader.next(), std::nullopt);
  EXPECT_TRUE(reader.is_broken());
}

TEST(LspText, CountsUnitsOfUtf16) {
  const std::string text =
      "a\xF0\x9F\xA4\x96"
      "b\ne\xCC\x81x\n";  // an emoji; e and a combining accent
  EXPECT_EQ(byte_at(text, {0, 1}), 1U);
  EXPECT_EQ(byte_at(text, {0, 3}), 5U);
  EXPECT_EQ(byte_at(text, {0, 2}), 5U);   // within the emoji: behind it
  EXPECT_EQ(byte_at(text, {0, 99}), 6U);  // the end of the line
  EXPECT_EQ(byte_at(text, {1, 2}), 10U);
  EXPECT_EQ(byte_at(text, {9, 0}), text.size());
  for (const std::size_t byte : {0U, 1U, 5U, 6U, 7U, 8U, 10U, 11U}) {
    const Position position = position_at(text, byte);
    EXPECT_EQ(byte_at(text, position), byte) << byte;
  }
}

TEST(FileUri, NamesFiles) {
  EXPECT_EQ(path_of_uri("file:///a%20b/c.yaml"), "/a b/c.yaml");
  EXPECT_EQ(path_of_uri("file://host/a"), "/a");
  EXPECT_EQ(path_of_uri("file:///a%2"), "/a%2");
  EXPECT_EQ(path_of_uri("untitled:1"), "");
  EXPECT_EQ(uri_of_path("/a b/ü.yaml"), "file:///a%20b/%C3%BC.yaml");
  EXPECT_EQ(path_of_uri(uri_of_path("/x#?%/y")), "/x#?%/y");
}

}  // namespace
}  // namespace eagerx::gen::lsp
