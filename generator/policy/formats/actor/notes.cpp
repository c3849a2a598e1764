// Notes on files, for people.
#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

#include "generator/policy/formats/actor/actor.hpp"
#include "generator/policy/formats/tensors/numbers.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

/// "angle (2), theta_dot" as two parts, of two numbers and of one. Nothing if a size makes no
/// sense.
std::optional<std::vector<NamedPart>> parts_of(const std::string& text) {
  constexpr std::uint64_t kMost = std::uint64_t{1} << 23U;
  std::vector<NamedPart> parts(1);
  bool in_size = false;
  std::string digits;
  for (const char c : text) {
    if (c == ',') {
      parts.emplace_back();
    } else if (c == '(' || c == ')') {
      in_size = c == '(';
      if (in_size) {
        digits.clear();
        continue;
      }
      const char* end = digits.data() + digits.size();
      const auto result = std::from_chars(digits.data(), end, parts.back().size);
      const bool fits = parts.back().size >= 1 && parts.back().size <= kMost;
      if (result.ec != std::errc{} || result.ptr != end || !fits) return std::nullopt;
    } else if (in_size) {
      digits += c;
    } else if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.' ||
               c == '/') {
      parts.back().name += c;
    }
  }
  if (in_size) return std::nullopt;
  if (parts.size() == 1 && parts.front().name.empty()) parts.clear();
  return parts;
}

class Notes {
 public:
  Notes(const TensorTable& table, PolicyProblem& problem) : table_(table), problem_(problem) {}

  std::optional<PolicyFacts> read() {
    PolicyFacts facts;
    facts.contract.algorithm = upper(text("algo"));
    const std::string said =
        text("activation").empty() ? text("activation_fn") : text("activation");
    const bool read =
        read_observations(facts) && read_activation("activation", said, facts.activation) &&
        read_activation("output_activation", text("output_activation"), facts.output_activation) &&
        read_action(facts) && bounds("low", facts.contract.action_low) &&
        bounds("high", facts.contract.action_high) && one("clip_obs", facts.clip) &&
        one("epsilon", facts.epsilon) && one("rate", facts.contract.rate_hz);
    if (!read) return std::nullopt;
    return facts;
  }

 private:
  static constexpr double kMostChoice = 1e9;

  std::string text(const char* key) const {
    const auto found = table_.notes.find(key);
    return found == table_.notes.end() ? std::string() : found->second;
  }
  Refused fail(const char* key) {
    return refuse(
        problem_, "E0626",
        fmt::format("has metadata `{}: {}` that makes no sense", key, printable(text(key))),
        "correct it, or leave it out");
  }

  bool read_observations(PolicyFacts& facts) {
    auto parts = parts_of(text("obs"));
    if (!parts) return fail("obs");
    if (!parts->empty()) facts.observations = 0;
    for (const NamedPart& part : *parts) {
      *facts.observations += static_cast<std::int64_t>(part.size);
    }
    facts.contract.observations = std::move(*parts);
    return true;
  }
  bool read_activation(const char* key, const std::string& name, std::optional<Activation>& out) {
    if (name.empty()) return true;
    out = activation_of(name);
    return out.has_value() || fail(key);
  }
  bool read_action(PolicyFacts& facts) {
    const std::string squash = upper(text("squash"));
    if (squash == "TRUE") facts.action = ActionKind::squashed;
    if (squash == "FALSE" && facts.contract.algorithm != "DQN") facts.action = ActionKind::raw;
    if (!squash.empty() && squash != "TRUE" && squash != "FALSE") return fail("squash");
    return read_choice(facts);
  }
  /// The whole number that the first output of each choice stands for, of a policy that chooses,
  /// and of several choices how many outputs each is among.
  bool read_choice(PolicyFacts& facts) {
    if (text("first_choice").empty()) return true;
    std::vector<double> firsts, counts;
    if (!whole_numbers("first_choice", -kMostChoice, firsts)) return false;
    if (firsts.empty() || facts.action) return fail("first_choice");
    if (!whole_numbers("choices", 1.0, counts)) return false;
    if (firsts.size() != std::max<std::size_t>(counts.size(), 1)) return fail("first_choice");
    facts.action = ActionKind::argmax;
    for (const double first : firsts)
      facts.contract.first_choices.push_back(static_cast<std::int64_t>(first));
    for (const double count : counts) {
      facts.contract.groups.push_back(static_cast<std::uint32_t>(count));
      facts.actions = facts.actions.value_or(0) + static_cast<std::int64_t>(count);
    }
    return true;
  }
  /// Of the metadata `key`, if it is there.
  bool whole_numbers(const char* key, double least, std::vector<double>& values) {
    if (text(key).empty()) return true;
    if (!bounds(key, values)) return false;
    const bool good = ranges::all_of(values, [&](double value) {
      return std::trunc(value) == value && value >= least && value <= kMostChoice;
    });
    return good || fail(key);
  }
  bool bounds(const char* key, std::vector<double>& out) {
    const std::string note = text(key);
    if (!note.empty()) {
      const auto values = numbers_in(note);
      if (!values) return fail(key);
      out = *values;
    } else if (const StoredTensor* tensor = table_.find(key); tensor != nullptr) {
      out = values_of(*tensor);
    }
    const bool finite =
        std::none_of(out.begin(), out.end(), [](double value) { return std::isnan(value); });
    return finite || fail(key);
  }
  bool one(const char* key, std::optional<double>& out) {
    std::vector<double> values;
    if (!bounds(key, values)) return false;
    if (values.empty()) return true;
    out = values.front();
    return (values.size() == 1 && *out > 0.0) || fail(key);
  }

  const TensorTable& table_;
  PolicyProblem& problem_;
};

}  // namespace

std::optional<PolicyFacts> facts_of_notes(const TensorTable& table, PolicyProblem& problem) {
  return Notes(table, problem).read();
}

}  // namespace eagerx::gen
