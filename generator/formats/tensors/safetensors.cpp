// safetensors: eight bytes of length, a JSON header, the values.
#include <fmt/core.h>

#include <algorithm>

#include "generator/formats/actor/actor.hpp"
#include "generator/formats/tensors/containers.hpp"
#include "generator/formats/tensors/json.hpp"

namespace eagerx::gen {
namespace {

constexpr std::size_t kLengthSize = 8;
constexpr const char* kDamaged = "the file is damaged or truncated: save it again";

std::optional<ElementType> type_of(std::string_view name) {
  if (name == "F16") return ElementType::float16;
  if (name == "BF16") return ElementType::bfloat16;
  if (name == "F32") return ElementType::float32;
  if (name == "F64") return ElementType::float64;
  if (name == "I8") return ElementType::int8;
  if (name == "U8") return ElementType::uint8;
  if (name == "I16") return ElementType::int16;
  if (name == "I32") return ElementType::int32;
  if (name == "I64") return ElementType::int64;
  if (name == "BOOL") return ElementType::boolean;
  return std::nullopt;
}

/// The whole numbers of a list, or nothing.
std::optional<std::vector<std::int64_t>> integers(const nlohmann::json* value) {
  if (value == nullptr || !value->is_array()) return std::nullopt;
  std::vector<std::int64_t> result;
  for (const nlohmann::json& item : *value) {
    if (!item.is_number_integer() ||
        (item.is_number_unsigned() && item.get<std::uint64_t>() > std::uint64_t{INT64_MAX})) {
      return std::nullopt;
    }
    result.push_back(item.get<std::int64_t>());
  }
  return result;
}

struct Place {
  std::size_t begin, end;
  std::string name;
};

std::optional<Place> add_tensor(const std::string& name, const nlohmann::json& entry,
                                std::string_view data, TensorTable& table, PolicyProblem& problem) {
  const auto fail = [&](const std::string& how) {
    return refuse(problem, "E0614", fmt::format("has tensor `{}` {}", printable(name), how),
                  kDamaged);
  };
  const std::string type_name = text_of(member(entry, "dtype"));
  const auto type = type_of(type_name);
  const auto shape = integers(member(entry, "shape"));
  const auto offsets = integers(member(entry, "data_offsets"));
  if (!shape || !offsets || offsets->size() != 2) return fail("without shape or place");
  if (!type) {
    return refuse(
        problem, "E0615",
        fmt::format("has tensor `{}` of type `{}`", printable(name), printable(type_name)),
        "save it as float32");
  }
  const std::int64_t begin = (*offsets)[0];
  const std::int64_t end = (*offsets)[1];
  if (begin < 0 || end < begin || static_cast<std::uint64_t>(end) > data.size()) {
    return fail("that lies outside of the file");
  }
  const auto count = element_count(*shape);
  const auto bytes = static_cast<std::uint64_t>(end - begin);
  if (!count || static_cast<std::uint64_t>(*count) * size_of(*type) != bytes) {
    return fail(fmt::format("of shape {} in {} bytes", show(*shape), bytes));
  }
  const auto first = static_cast<std::size_t>(begin);
  StoredTensor tensor{*type, *shape, {}, data.substr(first, static_cast<std::size_t>(bytes))};
  if (!table.add(name, std::move(tensor), problem)) return std::nullopt;
  return Place{first, static_cast<std::size_t>(end), name};
}

}  // namespace

bool read_safetensors_table(std::string_view bytes, TensorTable& table, PolicyProblem& problem) {
  const auto fail = [&](const char* how) {
    problem = {"E0604", fmt::format("is a safetensors file {}", how), kDamaged};
    return false;
  };
  if (bytes.size() < kLengthSize) return fail("without a header");
  std::uint64_t length = 0;
  for (std::size_t i = kLengthSize; i-- > 0;) {
    length = length << 8U | static_cast<unsigned char>(bytes[i]);
  }
  if (length > bytes.size() - kLengthSize) return fail("that ends inside of its header");
  const auto header = parse_json(bytes.substr(kLengthSize, static_cast<std::size_t>(length)));
  if (!header || !header->is_object()) return fail("whose header is not one JSON object");
  const std::string_view data = bytes.substr(kLengthSize + static_cast<std::size_t>(length));
  std::vector<Place> places;
  for (const auto& [name, entry] : header->items()) {
    if (name == "__metadata__") {
      if (!entry.is_object()) return fail("whose metadata is not an object");
      for (const auto& [key, value] : entry.items()) table.notes[key] = text_of(&value);
      continue;
    }
    const auto place = add_tensor(name, entry, data, table, problem);
    if (!place) return false;
    places.push_back(*place);
  }
  // Tensors that share bytes are a way to hide one, and no writer makes them.
  std::sort(places.begin(), places.end(), [](const Place& a, const Place& b) {
    return a.begin != b.begin ? a.begin < b.begin : a.end < b.end;
  });
  for (std::size_t i = 1; i < places.size(); ++i) {
    if (places[i].begin >= places[i - 1].end) continue;
    problem = {"E0614",
               fmt::format("has tensors `{}` and `{}` in the same place",
                           printable(places[i - 1].name), printable(places[i].name)),
               kDamaged};
    return false;
  }
  return true;
}

std::optional<Network> read_safetensors(std::string_view bytes, const ReadContext& context,
                                        PolicyProblem& problem) {
  TensorTable table;
  if (!read_safetensors_table(bytes, table, problem)) return std::nullopt;
  auto facts = facts_of_notes(table, problem);
  if (!facts) return std::nullopt;
  facts->format = "safetensors";
  return make_actor(table, *facts, context, problem);
}

}  // namespace eagerx::gen
