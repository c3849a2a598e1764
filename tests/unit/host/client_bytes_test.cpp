// runtime/host/web_socket: what a client sends, before the library has it (RFC 6455, 5.1 and 5.2).
#include "runtime/host/web_socket/client_bytes.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <string_view>

namespace eagerx::web_socket {
namespace {

using namespace std::string_literals;
using namespace std::string_view_literals;

constexpr std::string_view kRequest = "GET / HTTP/1.1\r\nHost: here\r\n\r\n";
constexpr char kReserved = '\x83';  // what the library refuses with 1002

/// A frame with `size` bytes, all 7.
std::string frame(std::size_t size, bool is_masked = true) {
  constexpr std::size_t kShort = 126, kMiddle = 65536;
  const unsigned mask = is_masked ? 0x80 : 0;
  const int bytes = size < kShort ? 0 : size < kMiddle ? 2 : 8;
  std::string text = "\x81";
  text += static_cast<char>(mask | (bytes == 0 ? size : bytes == 2 ? 126U : 127U));
  for (int i = bytes - 1; i >= 0; --i) text += static_cast<char>(size >> (8 * i));
  return text + (is_masked ? "mask" : "") + std::string(size, '\7');
}

/// Bytes of a request and after it that pass if it comes in pieces of `at_once` bytes.
ClientBytes given(const std::string& frames, std::size_t at_once) {
  ClientBytes bytes;
  const std::string all = std::string(kRequest) + frames;
  for (std::size_t at = 0; at < all.size(); at += at_once) {
    bytes.add(std::string_view(all).substr(at, at_once));
    if (at + at_once >= kRequest.size()) bytes.answered(ClientBytes::Answer::web_socket);
  }
  return bytes;
}

TEST(ClientBytes, MaskedFramesPassAsTheyAre) {
  std::string frames;
  for (const std::size_t size : {0, 1, 125, 126, 127, 300, 65535, 65536, 70000})
    frames += frame(size);
  for (const std::size_t at_once : {1, 2, 3, 7, 1000, 1'000'000}) {
    const ClientBytes bytes = given(frames, at_once);
    EXPECT_EQ(bytes.passed, std::string(kRequest) + frames) << at_once;
    EXPECT_FALSE(bytes.is_unmasked());
  }
}

TEST(ClientBytes, AnUnmaskedFrameIsMadeOneThatTheLibraryRefuses) {
  for (const std::size_t size : {0, 5, 126, 70000}) {
    for (const std::size_t at_once : {1, 2, 3, 1'000'000}) {
      const ClientBytes bytes = given(frame(3) + frame(size, false) + frame(3), at_once);
      EXPECT_EQ(bytes.passed, std::string(kRequest) + frame(3) + kReserved) << size;
      EXPECT_TRUE(bytes.is_unmasked());
    }
  }
}

// Lengths that no frame has do not wrap into short ones.
TEST(ClientBytes, NothingIsAHeadWithinTheLongestFrame) {
  const std::string longest = "\x81\xff"s + std::string(8, '\xff') + "mask";
  const ClientBytes bytes = given(longest + frame(5, false), 1'000'000);
  EXPECT_EQ(bytes.passed, std::string(kRequest) + longest + frame(5, false));
}

TEST(ClientBytes, WhatFollowsARequestWaitsForTheAnswer) {
  ClientBytes bytes;
  bytes.add(std::string(kRequest) + frame(3));
  EXPECT_EQ(bytes.passed, kRequest);
  EXPECT_TRUE(bytes.is_waiting());
  bytes.answered(ClientBytes::Answer::web_socket);
  EXPECT_EQ(bytes.passed, std::string(kRequest) + frame(3));
  EXPECT_FALSE(bytes.is_waiting());
}

TEST(ClientBytes, WhatFollowsAPageIsNoFrame) {
  ClientBytes bytes;
  bytes.add(kRequest);
  bytes.answered(ClientBytes::Answer::page);
  bytes.add(kRequest);
  EXPECT_EQ(bytes.passed, std::string(kRequest) + std::string(kRequest));
}

// The library ends lines at LF alone; frames would begin where this still reads the request.
TEST(ClientBytes, ARequestWhoseLinesEndInLfIsNone) {
  for (const std::string_view text :
       {"GET / HTTP/1.1\n\n"sv, "GET / HTTP/1.1\r\nHost: x\n\r\n"sv, "\n"sv}) {
    ClientBytes bytes;
    bytes.add(text);
    EXPECT_TRUE(bytes.is_no_request()) << text;
    bytes.add(frame(3, false));
    EXPECT_EQ(bytes.passed, text.substr(0, bytes.passed.size()));
  }
}

}  // namespace
}  // namespace eagerx::web_socket
