// safetensors: eight bytes of length, a JSON header, the values.
#include <fmt/core.h>

#include <algorithm>

#include "generator/policy/formats/tensors/containers.hpp"
#include "generator/support/json/json.hpp"

namespace eagerx::gen {
namespace {

constexpr std::size_t kLengthSize = 8;

struct Place {
  std::size_t begin, end;
  std::string name;
};

std::optional<Place> add_tensor(const std::string& name, const Json& entry, std::string_view data,
                                TensorTable& table, PolicyProblem& problem) {
  const auto fail = [&](const std::string& how) {
    return refuse(problem, "E0614", fmt::format("has tensor `{}` {}", printable(name), how),
                  kCutShort);
  };
  const std::string type_name = text_of(member(&entry, "dtype"));
  const auto type = safetensors_type(type_name);
  const auto shape = integers_of(member(&entry, "shape"));
  const auto offsets = integers_of(member(&entry, "data_offsets"));
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
    return refuse(problem, "E0604", fmt::format("is a safetensors file {}", how), kCutShort);
  };
  if (bytes.size() < kLengthSize) return fail("without a header");
  const std::uint64_t length = little_endian(bytes, kLengthSize);
  if (length > bytes.size() - kLengthSize) return fail("that ends inside of its header");
  const auto header = parse_json(bytes.substr(kLengthSize, static_cast<std::size_t>(length)));
  const auto* entries = header ? header->as<Json::Object>() : nullptr;
  if (entries == nullptr) return fail("whose header is not one JSON object");
  const std::string_view data = bytes.substr(kLengthSize + static_cast<std::size_t>(length));
  std::vector<Place> places;
  for (const auto& [name, entry] : *entries) {
    if (name == "__metadata__") {
      const auto* notes = entry.as<Json::Object>();
      if (notes == nullptr) return fail("whose metadata is not an object");
      for (const auto& [key, value] : *notes) table.notes[key] = text_of(&value);
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
    return refuse(problem, "E0614",
                  fmt::format("has tensors `{}` and `{}` in the same place",
                              printable(places[i - 1].name), printable(places[i].name)),
                  kCutShort);
  }
  return true;
}

}  // namespace eagerx::gen
