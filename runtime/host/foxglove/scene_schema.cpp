// The messages are Foxglove's: https://github.com/foxglove/foxglove-sdk, schemas/jsonschema.
#include <initializer_list>
#include <runtime/host/foxglove/scene_update.hpp>
#include <utility>

namespace eagerx::foxglove {
namespace {

struct Member {
  const char* name;
  std::string schema;
};

std::string object(std::initializer_list<Member> members) {
  std::string properties, required;
  for (const auto& [name, schema] : members) {
    const std::string quoted = (properties.empty() ? "\"" : ",\"") + std::string(name) + "\"";
    properties.append(quoted).append(":").append(schema);
    required += quoted;
  }
  return R"({"type":"object","properties":{)" + properties + "},\"required\":[" + required + "]}";
}
std::string array(const std::string& items) {
  return R"({"type":"array","items":)" + items + "}";
}

const char* const kNumber = R"({"type":"number"})";
const char* const kWhole = R"({"type":"integer"})";
const char* const kText = R"({"type":"string"})";
const char* const kFlag = R"({"type":"boolean"})";

std::string vector() {
  return object({{"x", kNumber}, {"y", kNumber}, {"z", kNumber}});
}
std::string colour() {
  return object({{"r", kNumber}, {"g", kNumber}, {"b", kNumber}, {"a", kNumber}});
}
std::string pose() {
  return object(
      {{"position", vector()},
       {"orientation", object({{"x", kNumber}, {"y", kNumber}, {"z", kNumber}, {"w", kNumber}})}});
}
std::string time() {
  return object({{"sec", kWhole}, {"nsec", kWhole}});
}

std::string entity() {
  const std::string size = vector();
  return object(
      {{"timestamp", time()},
       {"frame_id", kText},
       {"id", kText},
       {"lifetime", time()},
       {"frame_locked", kFlag},
       {"metadata", array(object({{"key", kText}, {"value", kText}}))},
       {"arrows", array(object({{"pose", pose()},
                                {"shaft_length", kNumber},
                                {"shaft_diameter", kNumber},
                                {"head_length", kNumber},
                                {"head_diameter", kNumber},
                                {"color", colour()}}))},
       {"cubes", array(object({{"pose", pose()}, {"size", size}, {"color", colour()}}))},
       {"spheres", array(object({{"pose", pose()}, {"size", size}, {"color", colour()}}))},
       {"cylinders", array(object({{"pose", pose()},
                                   {"size", size},
                                   {"bottom_scale", kNumber},
                                   {"top_scale", kNumber},
                                   {"color", colour()}}))},
       {"lines", array(object({{"type", kWhole},
                               {"pose", pose()},
                               {"thickness", kNumber},
                               {"scale_invariant", kFlag},
                               {"points", array(vector())},
                               {"color", colour()},
                               {"colors", array(colour())},
                               {"indices", array(kWhole)}}))},
       {"triangles", array(object({{"pose", pose()},
                                   {"points", array(vector())},
                                   {"color", colour()},
                                   {"colors", array(colour())},
                                   {"indices", array(kWhole)}}))},
       {"texts", array(object({{"pose", pose()},
                               {"billboard", kFlag},
                               {"font_size", kNumber},
                               {"scale_invariant", kFlag},
                               {"color", colour()},
                               {"text", kText}}))},
       {"models", array(object({{"pose", pose()},
                                {"scale", vector()},
                                {"color", colour()},
                                {"override_color", kFlag},
                                {"url", kText},
                                {"media_type", kText},
                                {"data", R"({"type":"string","contentEncoding":"base64"})"}}))}});
}

}  // namespace

std::string scene_update_schema() {
  return object(
      {{"deletions", array(object({{"timestamp", time()}, {"type", kWhole}, {"id", kText}}))},
       {"entities", array(entity())}});
}

}  // namespace eagerx::foxglove
