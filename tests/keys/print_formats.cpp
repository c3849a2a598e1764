// The tables of graphs and manifests as JSON, for tests/keys/run.
#include <cstdio>

#include "generator/frontend/library/library.hpp"
#include "generator/support/json/json.hpp"

namespace eagerx::gen {
namespace {

const char* kind_of(Format::Kind kind) {
  switch (kind) {
    case Format::Kind::record:
      return "record";
    case Format::Kind::map:
      return "map";
    case Format::Kind::list:
      return "list";
    case Format::Kind::one_of:
      return "one_of";
    case Format::Kind::keyword:
      return "keyword";
    case Format::Kind::boolean:
      return "boolean";
    case Format::Kind::integer:
    case Format::Kind::memory:
    case Format::Kind::decimal:
    case Format::Kind::number:
      return "number";
    case Format::Kind::any:
      return "any";
    default:
      return "text";
  }
}

Json json_of(const Format& format) {
  Json json = {{"kind", kind_of(format.kind)}};
  if (format.item) json["item"] = json_of(*format.item);
  if (format.kind == Format::Kind::keyword) json["keywords"] = Json(format.keywords);
  if (format.kind == Format::Kind::one_of) {
    json["options"] = Json::list();
    for (const auto& option : format.options) json["options"].push_back(json_of(*option));
  }
  if (format.kind == Format::Kind::record) {
    json["fields"] = Json::object();
    for (const auto& field : format.fields) {
      Json item = json_of(*field.format);
      item["required"] = field.required;
      json["fields"][field.name] = std::move(item);
    }
  }
  return json;
}

}  // namespace
}  // namespace eagerx::gen

int main() {
  using namespace eagerx::gen;
  Json all = Json::object();
  all["graph"] = json_of(graph_format());
  for (const auto& kind : manifest_kinds()) all[kind] = json_of(*manifest_format(kind));
  std::puts(dump_json(all).c_str());
}
