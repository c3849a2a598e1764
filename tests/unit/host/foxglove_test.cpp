// runtime/host/foxglove: what clients say, who may do what, and drawings in space.
#include <gtest/gtest.h>

#include <cmath>
#include <eagerx/message.hpp>
#include <eagerx/scene.hpp>
#include <runtime/host/base/json_reader.hpp>
#include <runtime/host/foxglove/access.hpp>
#include <runtime/host/foxglove/client_message.hpp>
#include <runtime/host/foxglove/scene_update.hpp>
#include <string>

namespace eagerx::foxglove {
namespace {

using Asked = ClientMessage::Kind;

TEST(ClientMessage, ParametersAreNumbersFlagsOrNothing) {
  const auto message = read_client_text(
      R"({"op":"setParameters","id":"x","parameters":[{"name":"a","value":1.5},)"
      R"({"name":"b","value":[1,true]},{"name":"c"},{"name":"d","value":null},)"
      R"({"name":"e","value":"1"},{"name":"f","value":[]},{"name":"g","value":[[1]]}]})");
  ASSERT_EQ(message.kind, Asked::set_parameters);
  EXPECT_EQ(message.id, "x");
  const auto& p = message.parameters;
  ASSERT_EQ(p.size(), 7U);
  EXPECT_EQ(p[0].numbers, std::vector{1.5});
  EXPECT_FALSE(p[0].has_flags);
  EXPECT_EQ(p[1].numbers, (std::vector{1.0, 1.0}));
  EXPECT_TRUE(p[1].has_flags);
  EXPECT_TRUE(p[2].numbers.empty() && !p[2].is_wrong);
  EXPECT_TRUE(p[3].numbers.empty() && !p[3].is_wrong);
  EXPECT_TRUE(p[4].is_wrong && p[5].is_wrong && p[6].is_wrong);
}

TEST(ClientMessage, CallsAreReadUpToTheirEnd) {
  const std::string call("\2\4\0\0\0\1\2\0\0\4\0\0\0json{}", 19);
  const auto message = read_client_bytes(call);
  ASSERT_EQ(message.kind, Asked::call);
  EXPECT_EQ(message.service, 4U);
  EXPECT_EQ(message.call_id, 513U);
  EXPECT_EQ(message.encoding, "json");
  EXPECT_EQ(message.request, "{}");
  for (std::size_t size = 0; size < 17; ++size)
    EXPECT_EQ(read_client_bytes(call.substr(0, size)).kind, Asked::wrong) << size;
}

TEST(ClientMessage, StepsAreAWholeNumberFrom1On) {
  EXPECT_EQ(steps_of_request(""), 1U);
  EXPECT_EQ(steps_of_request("{}"), 1U);
  EXPECT_EQ(steps_of_request(R"({"steps":4294967295})"), 4294967295U);
  for (const char* wrong : {"[]", "3", R"({"steps":0})", R"({"steps":4294967296})",
                            R"({"steps":1.5})", R"({"steps":"1"})", R"({"steps":-1})"})
    EXPECT_EQ(steps_of_request(wrong), 0U) << wrong;
}

TEST(Access, WhatIsRealNeedsTheKey) {
  const std::string key(32, 'k');
  const Handshake keyless, with_key{key, "https://example.org"}, wrong{std::string(32, 'x'), ""};
  const Access open{"", true, false}, real{"", true, true}, guarded{key, true, true},
      beyond{"", false, false};
  EXPECT_TRUE(open.may_change(keyless));
  EXPECT_FALSE(real.may_change(keyless));
  EXPECT_FALSE(real.may_read(with_key)) << "there is no key";
  EXPECT_FALSE(beyond.may_change(keyless));
  EXPECT_FALSE(guarded.may_change(keyless));
  EXPECT_TRUE(guarded.may_read(keyless));
  EXPECT_FALSE(guarded.may_read(wrong));
  EXPECT_FALSE(guarded.may_change(wrong));
  EXPECT_TRUE(guarded.may_change(with_key));
}

/// The first number behind `name`.
double number_behind(const std::string& text, const std::string& name) {
  const std::size_t at = text.find("\"" + name + "\":");
  return at == std::string::npos ? std::nan("") : std::stod(text.substr(at + name.size() + 3));
}

TEST(SceneUpdate, APlaneDrawingStandsUpright) {
  Array<float, 4, 16> scene{};
  SceneWriter<Array<float, 4, 16>> to(scene);
  to.view({1.0F, 2.0F}, 4.0F, 0xffffff);
  to.circle({0.5F, 0.25F}, 0.125F, fill(0xff0000, 0.5F));
  std::string text = scene_update(scene.data, 4, 1'500'000'000);
  EXPECT_EQ(number_behind(text, "sec"), 1);
  EXPECT_EQ(number_behind(text, "nsec"), 500'000'000);
  EXPECT_EQ(number_behind(text, "x"), 0.5);
  EXPECT_EQ(number_behind(text, "z"), 0.25);
  EXPECT_EQ(number_behind(text, "r"), 1);
  EXPECT_EQ(number_behind(text, "a"), 0.5);
  to.on_screen();
  to.text({0.5F, 0.5F}, 0.1F, "x", 0);  // the middle of the picture is that of the view
  text = scene_update(scene.data, 4, 0);
  const std::string texts = text.substr(text.find("\"texts\""));
  EXPECT_NEAR(number_behind(texts, "z"), 2.0, 1e-6);
  EXPECT_NEAR(number_behind(texts, "font_size"), 0.4, 1e-6);
}

TEST(SceneUpdate, ACapsuleHasItsEndsWhereItPoints) {
  Array<float, 2, 16> scene{};
  SceneWriter<Array<float, 2, 16>> to(scene);
  const float half = std::sqrt(0.5F);
  to.capsule({{1.0F, 0.0F, 0.0F}, half, 0.0F, half, 0.0F}, 0.1F, 2.0F, 0);  // z to x
  const std::string text = scene_update(scene.data, 2, 0);
  const std::size_t spheres = text.find("\"spheres\"");
  const std::size_t second = text.find("\"pose\"", text.find("\"pose\"", spheres) + 1);
  EXPECT_NEAR(number_behind(text.substr(spheres), "x"), 0.0, 1e-5);
  EXPECT_NEAR(number_behind(text.substr(second), "x"), 2.0, 1e-5);
}

TEST(SceneUpdate, AnyNumbersAreJson) {
  Array<float, 1, 16> scene{};
  const float numbers[] = {NAN, INFINITY, -INFINITY, 0.0F, -1e38F, 3e38F, 1.5F};
  for (int shape = 0; shape < 64; ++shape) {
    for (const float number : numbers) {
      for (std::size_t i = 0; i < 16; ++i) scene[i] = number;
      scene[0] = static_cast<float>(shape);
      const std::string text = scene_update(scene.data, 1, 0);
      EXPECT_TRUE(host::read_json(text)) << shape << " " << number << " " << text;
    }
  }
}

}  // namespace
}  // namespace eagerx::foxglove
