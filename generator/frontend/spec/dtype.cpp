#include "generator/frontend/spec/dtype.hpp"

#include <array>
#include <limits>

#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

struct DtypeFacts {
  std::string_view name;
  bool floating;
  double low, high;
};

template <class T>
constexpr DtypeFacts facts(std::string_view name) {
  return {name, !std::numeric_limits<T>::is_integer,
          static_cast<double>(std::numeric_limits<T>::lowest()),
          static_cast<double>(std::numeric_limits<T>::max())};
}

// In the order of the enumeration.
constexpr std::array kFacts = {facts<float>("float32"),
                               facts<double>("float64"),
                               facts<std::int8_t>("int8"),
                               facts<std::int16_t>("int16"),
                               facts<std::int32_t>("int32"),
                               facts<std::int64_t>("int64"),
                               facts<std::uint8_t>("uint8"),
                               facts<std::uint16_t>("uint16"),
                               facts<std::uint32_t>("uint32"),
                               facts<std::uint64_t>("uint64"),
                               facts<bool>("bool")};

const DtypeFacts& facts_of(Dtype dtype) {
  return kFacts.at(static_cast<std::size_t>(dtype));
}

}  // namespace

std::string_view to_string(Dtype dtype) {
  return facts_of(dtype).name;
}

std::optional<Dtype> dtype_of(std::string_view name) {
  const auto* found = ranges::find(kFacts, name, &DtypeFacts::name);
  if (found == kFacts.end()) return std::nullopt;
  return static_cast<Dtype>(found - kFacts.begin());
}

const std::vector<std::string>& dtype_names() {
  static const std::vector<std::string> kNames = [] {
    std::vector<std::string> names;
    names.reserve(kFacts.size());
    for (const auto& each : kFacts) names.emplace_back(each.name);
    return names;
  }();
  return kNames;
}

bool is_floating(Dtype dtype) {
  return facts_of(dtype).floating;
}
double lowest_of(Dtype dtype) {
  return facts_of(dtype).low;
}
double highest_of(Dtype dtype) {
  return facts_of(dtype).high;
}

}  // namespace eagerx::gen
