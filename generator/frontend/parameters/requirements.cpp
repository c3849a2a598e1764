#include "generator/frontend/parameters/requirements.hpp"

#include <fmt/format.h>

#include <utility>

#include "generator/support/diagnostics/join.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

struct FactOf {
  template <class T>
  ConditionValue operator()(const std::vector<T>& list) const {
    return std::vector<ConditionNumber>(list.begin(), list.end());
  }
  ConditionValue operator()(const std::shared_ptr<const ModelUse>& model) const {
    return model->object->id.value;
  }
  template <class T>
  ConditionValue operator()(const T& value) const {
    return value;
  }
};

/// A long list, which may be from a file, by its ends.
std::string brief(const ConditionValue& value) {
  constexpr std::size_t kMostShown = 40;  // order x order values of a small system
  const auto* list = std::get_if<std::vector<ConditionNumber>>(&value);
  if (list == nullptr || list->size() <= kMostShown) return to_string(value);
  return fmt::format("[{}, {}, … {}], {} values", to_string((*list)[0]), to_string((*list)[1]),
                     to_string(list->back()), list->size());
}

/// "`cutoff_hz` is 20, `rate` is 30"
std::string shown(const Condition& condition, const Facts& facts) {
  std::vector<std::string> items;
  for (const auto& step : condition) {
    if (step.op != ConditionStep::Op::fact) continue;
    const std::string item = fmt::format("`{}` is {}", step.written, brief(facts.at(step.fact)));
    if (!contains(items, item)) items.push_back(item);
  }
  return fmt::format("{}", join(items, ", "));
}

/// The first parameter of the condition that was given, else the entity.
Span place_of(const Condition& condition, const Config& config, Span entity) {
  for (const auto& step : condition) {
    const auto item = ranges::find_if(config, [&](const ConfigValue& c) {
      return c.given && c.parameter->name.value == step.fact;
    });
    if (item != config.end()) return item->span;
  }
  return entity;
}

}  // namespace

void add_config(Facts& facts, const Config& config) {
  for (const auto& item : config)
    facts[item.parameter->name.value] = std::visit(FactOf{}, item.value);
}

bool meets_requirements(const Entity& entity, const Config& config) {
  Facts facts;
  add_config(facts, config);
  return ranges::all_of(entity.requirements, [&](const auto& requirement) {
    return holds(requirement.that, facts).value_or(true);
  });
}

void check_requirements(const Entity& entity, const Config& config, Facts facts, Span span,
                        Diagnostics& diagnostics) {
  if (entity.requirements.empty()) return;
  add_config(facts, config);
  for (const auto& requirement : entity.requirements) {
    if (holds(requirement.that, facts).value_or(true)) continue;
    auto& problem = diagnostics.error(
        "E0328", place_of(requirement.that, config, span),
        fmt::format("`{}` requires that {}", entity.id.value, requirement.because));
    problem.label = shown(requirement.that, facts);
    problem.notes.push_back(
        {fmt::format("as its manifest says: `{}`", requirement.text), requirement.span, ""});
  }
}

void check_requirements(const Entity& entity, const Config& config,
                        const std::optional<Rational>& rate_hz, Span span,
                        Diagnostics& diagnostics) {
  Facts facts;
  if (rate_hz) facts["rate"] = rate_hz->to_double();
  check_requirements(entity, config, std::move(facts), span, diagnostics);
}

}  // namespace eagerx::gen
