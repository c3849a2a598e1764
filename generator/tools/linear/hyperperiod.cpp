#include "generator/tools/linear/hyperperiod.hpp"

#include <algorithm>

#include "generator/support/json/json.hpp"

namespace eagerx::gen {
namespace {

std::vector<double> numbers_in(const Json& list) {
  std::vector<double> numbers;
  for (const Json& item : *list.as<Json::List>()) numbers.push_back(number_of(&item).value_or(0.0));
  return numbers;
}

std::vector<std::size_t> words_in(const Json* list) {
  std::vector<std::size_t> words;
  for (const std::int64_t word : integers_of(list).value_or(std::vector<std::int64_t>()))
    words.push_back(static_cast<std::size_t>(word));
  return words;
}

ResetElement reset_element_of(const Json& item) {
  const auto& parts = *item.as<Json::List>();
  return {text_of(&parts[0]),
          static_cast<std::size_t>(number_of(&parts[1]).value_or(0.0)),
          number_of(&parts[2]).value_or(0.0),
          number_of(&parts[3]),
          number_of(&parts[4]),
          number_of(&parts[5]),
          number_of(&parts[6])};
}

/// Whether number `word`, of an object or a node, is element `k` and nothing else.
bool is_element(const Hyperperiod& from, const Json::List& rows, std::size_t word, std::size_t k) {
  const auto& row = *rows[word].as<Json::List>();
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (number_of(&row[i]).value_or(0.0) != (i == k ? 1.0 : 0.0)) return false;
  }
  return !from.system.state[word].is_message && from.after_reset[word] == from.states[k].value;
}

/// The number of the program that element `k` is; of several, first one of its owner.
std::size_t word_of(const Hyperperiod& from, const Json::List& rows, std::size_t k) {
  const std::string& state = from.states[k].state;
  const std::string owner = state.substr(0, state.rfind('.') + 1);
  std::size_t found = ResetElement::kNone;
  for (std::size_t word = 0; word < rows.size(); ++word) {
    if (!is_element(from, rows, word, k)) continue;
    if (from.system.state[word].name.starts_with(owner)) return word;
    if (found == ResetElement::kNone) found = word;
  }
  return found;
}

}  // namespace

bool is_constant(const SampledSystem& system, std::size_t word) {
  const std::vector<double>& row = system.a[word];
  for (std::size_t k = 0; k < row.size(); ++k) {
    if (row[k] != (k == word ? 1.0 : 0.0)) return false;
  }
  return std::ranges::all_of(system.b[word], [](double x) { return x == 0.0; });
}

bool is_parameter(const Hyperperiod& there, const ResetElement& element) {
  if (element.word == ResetElement::kNone) return element.state.ends_with("/delay");
  return is_constant(there.system, element.word);
}

std::optional<Hyperperiod> read_hyperperiod(std::string_view text, const Plan& plan) {
  const auto json = parse_json(text);
  auto system = json ? read_whole_system(*json, plan) : std::nullopt;
  if (!system) return std::nullopt;
  Hyperperiod result;
  result.system = std::move(*system);
  const auto& values = *member(&*json, "values")->as<Json::List>();
  result.after_reset = numbers_in(values[0]);
  result.next = numbers_in(values[1]);
  result.observed = numbers_in(values[2]);
  result.later = numbers_in(values[3]);
  for (const Json& item : *member(&*json, "states")->as<Json::List>())
    result.states.push_back(reset_element_of(item));
  result.settled = words_in(member(&*json, "settled"));
  const auto& reset = *member(&*json, "reset")->as<Json::List>();
  for (std::size_t k = 0; k < result.states.size(); ++k)
    result.states[k].word = word_of(result, reset, k);
  return result;
}

}  // namespace eagerx::gen
