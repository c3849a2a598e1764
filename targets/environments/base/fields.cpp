#include <cstddef>
#include <cstdint>
#include <runtime/host/base/json.hpp>
#include <string>
#include <targets/environments/base/fields.hpp>
#include <vector>

namespace eagerx::environments {
namespace {

void begin(host::Json& json, const char* name, const MessageType& type, std::uint32_t windows) {
  json.begin_object().key("name").text(name).key("shape").begin_list();
  if (windows > 1) json.whole(windows);
  for (const std::size_t side : type.shape) json.whole(side);
  json.end_list().key("dtype").text(type.dtype);
  json.key("window").whole(windows);
}

void bounds(host::Json& json, const MessageType& type, const std::vector<double>& elements,
            std::uint32_t windows) {
  json.begin_list();
  for (std::uint32_t w = 0; w < windows; ++w) {
    for (const double bound : elements) {
      if (type.dtype == "float32") {
        json.number(static_cast<float>(bound));
      } else {
        json.number(bound);
      }
    }
  }
  json.end_list();
}

std::size_t size_of(const MessageType& type) {
  std::size_t size = 1;
  for (const std::size_t side : type.shape) size *= side;
  return size;
}

std::string end(host::Json& json, std::size_t first) {
  return json.key("first").whole(first).end_object().str();
}

}  // namespace

void Fields::add(const char* name, const MessageType& type, std::uint32_t windows,
                 const std::vector<double>& low, const std::vector<double>& high) {
  host::Json json;
  begin(json, name, type, windows);
  bounds(json.key("low"), type, low, windows);
  bounds(json.key("high"), type, high, windows);
  texts_.push_back(end(json, columns_.first(texts_.size())));
}

void Fields::add(const char* name, const MessageType& type) {
  host::Json json;
  begin(json, name, type, 1);
  for (const char* key : {"low", "high"}) {
    json.key(key).begin_list();
    for (std::size_t i = 0; i < size_of(type); ++i) json.null();
    json.end_list();
  }
  texts_.push_back(end(json, columns_.first(texts_.size())));
}

std::string Fields::list() const {
  std::string result;
  for (const std::size_t field : columns_.order())
    result += (result.empty() ? "" : ", ") + texts_[field];
  return "[" + result + "]";
}

}  // namespace eagerx::environments
