// Statistics of observations in a separate file.
#include "generator/policy/formats/statistics.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "generator/policy/formats/actor/actor.hpp"
#include "generator/policy/formats/tensors/archive.hpp"
#include "generator/policy/formats/tensors/containers.hpp"
#include "generator/policy/formats/tensors/numbers.hpp"

namespace eagerx::gen {
namespace {

constexpr const char* kStatisticsHelp =
    "save it with `VecNormalize.save`, or as JSON: {\"mean\": […], \"var\": […], \"clip_obs\": 10, "
    "\"epsilon\": 1e-8}";

constexpr std::int64_t kMostStatistics = std::int64_t{1} << 23U;  // one array may be named often

Refused unusable(PolicyProblem& problem, std::string how) {
  return refuse(problem, "E0627", std::move(how), kStatisticsHelp);
}

std::optional<Normalization> checked(Normalization statistics, PolicyProblem& problem) {
  if (!check_statistics(statistics, problem)) return std::nullopt;
  return statistics;
}

/// Appends the arrays of one RunningMeanStd. False if they are none.
bool append_rms(const Pickle& pickle, const PickleValue& rms, Normalization& statistics) {
  constexpr std::size_t kMostFacts = 64;  // one dictionary may be there often
  const PickleValue* facts = pickle.dictionary_of(rms);
  if (facts == nullptr || facts->items.size() > 2 * kMostFacts) return false;
  const auto means = pickle.array(pickle.find(rms, "mean"));
  const auto variances = pickle.array(pickle.find(rms, "var"));
  if (!means || !variances) return false;
  const std::size_t count = statistics.mean.size() + statistics.variance.size();
  const std::int64_t more = element_count(means->shape).value_or(kMostStatistics) +
                            element_count(variances->shape).value_or(kMostStatistics);
  if (static_cast<std::int64_t>(count) + more > kMostStatistics) return false;
  for (const double value : values_of(*means)) statistics.mean.push_back(value);
  for (const double value : values_of(*variances)) statistics.variance.push_back(value);
  return true;
}

/// Of a Box, or of a Dict of them in the order of the pickle, which is that of the space's names:
/// gymnasium sorts those of a plain dict only.
bool append_all(const Pickle& pickle, const PickleValue& rms, Normalization& statistics) {
  constexpr std::size_t kMostParts = 10'000;
  if (rms.kind != PickleValue::Kind::dictionary) return append_rms(pickle, rms, statistics);
  if (rms.items.size() > 2 * kMostParts) return false;
  for (std::size_t i = 0; i + 1 < rms.items.size(); i += 2) {
    const std::string_view name = pickle.at(rms.items[i]).text;
    const std::size_t before = statistics.mean.size();
    if (name.size() > kLongestPickledName) return false;
    if (!append_rms(pickle, pickle.at(rms.items[i + 1]), statistics)) return false;
    statistics.parts.push_back({std::string(name), statistics.mean.size() - before});
  }
  return !rms.items.empty();
}

std::optional<Normalization> statistics_of_pickle(std::string_view bytes, PolicyProblem& problem) {
  const auto pickle = read_pickle(bytes, PickleNames::statistics, problem);
  if (!pickle) return std::nullopt;
  const PickleValue& top = pickle->top();
  const PickleValue* wanted = pickle->find(top, "norm_obs");
  if (wanted != nullptr && wanted->integer == 0) {
    return unusable(problem, "normalises no observations (`norm_obs=False`)");
  }
  const PickleValue* rms = pickle->find(top, "obs_rms");
  if (rms == nullptr) return unusable(problem, "has no `obs_rms`");
  Normalization statistics;
  if (!append_all(*pickle, *rms, statistics)) {
    return unusable(problem, "has an `obs_rms` without arrays `mean` and `var`");
  }
  const auto clip = pickle->number(pickle->find(top, "clip_obs"));
  const auto epsilon = pickle->number(pickle->find(top, "epsilon"));
  statistics.clip = clip.value_or(statistics.clip);
  statistics.epsilon = epsilon.value_or(statistics.epsilon);
  return checked(std::move(statistics), problem);
}

std::optional<Normalization> statistics_of_npz(std::string_view bytes, PolicyProblem& problem) {
  const auto archive = Archive::open(bytes, problem);
  TensorTable table;
  if (!archive || !read_npz(*archive, table, problem)) return std::nullopt;
  const auto find = [&](const char* a, const char* b) {
    const StoredTensor* found = table.find(a);
    return found != nullptr ? found : table.find(b);
  };
  const StoredTensor* mean = find("obs_rms.mean", "mean");
  const StoredTensor* variance = find("obs_rms.var", "var");
  if (mean == nullptr || variance == nullptr) return unusable(problem, "has no `mean` and `var`");
  const auto facts = facts_of_notes(table, problem);
  if (!facts) return std::nullopt;
  Normalization statistics;
  statistics.mean = values_of(*mean);
  statistics.variance = values_of(*variance);
  statistics.clip = facts->clip.value_or(statistics.clip);
  statistics.epsilon = facts->epsilon.value_or(statistics.epsilon);
  return checked(std::move(statistics), problem);
}

/// A key that would be read as if it were not there.
std::optional<std::string> unknown_key(const Json& object) {
  constexpr std::array kKnown = {"mean", "var", "count", "clip_obs", "epsilon", "obs_rms"};
  for (const auto& [key, value] : *object.as<Json::Object>()) {
    if (std::find(kKnown.begin(), kKnown.end(), key) == kKnown.end()) return key;
  }
  return std::nullopt;
}

std::optional<Normalization> statistics_of_json(std::string_view bytes, PolicyProblem& problem) {
  const auto value = parse_json(bytes);
  if (!value || !value->is<Json::Object>()) return unusable(problem, "is not one JSON object");
  const Json* rms = member(&*value, "obs_rms");
  const Json& from = rms != nullptr && rms->is<Json::Object>() ? *rms : *value;
  for (const Json* object : {&*value, &from}) {
    const auto key = unknown_key(*object);
    if (key) return unusable(problem, fmt::format("has an unknown `{}`", printable(*key)));
  }
  const auto means = numbers_of(member(&from, "mean"));
  const auto variances = numbers_of(member(&from, "var"));
  if (!means || !variances) return unusable(problem, "has no `mean` and `var`");
  Normalization statistics;
  statistics.mean = *means;
  statistics.variance = *variances;
  for (const auto& [key, target] :
       {std::pair{"clip_obs", &statistics.clip}, std::pair{"epsilon", &statistics.epsilon}}) {
    const Json* inner = member(&from, key);
    const Json* given = inner != nullptr ? inner : member(&*value, key);
    if (given == nullptr) continue;
    const auto number = number_of(given);
    if (!number) return unusable(problem, fmt::format("has a `{}` that is not a number", key));
    *target = *number;
  }
  return checked(std::move(statistics), problem);
}

}  // namespace

std::optional<Normalization> read_statistics(std::string_view bytes, PolicyProblem& problem) {
  if (bytes.starts_with("PK\x03\x04")) return statistics_of_npz(bytes, problem);
  if (bytes.starts_with("\x80")) return statistics_of_pickle(bytes, problem);
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  if (first != std::string_view::npos && bytes[first] == '{')
    return statistics_of_json(bytes, problem);
  return unusable(problem, "is neither a pickle, nor npz, nor JSON");
}

}  // namespace eagerx::gen
