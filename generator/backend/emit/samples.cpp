#include "generator/backend/emit/samples.hpp"

#include <fmt/format.h>

#include "generator/backend/emit/literals.hpp"
#include "generator/backend/emit/namer.hpp"

namespace eagerx::gen {
namespace {

std::string initializer(const std::vector<double>& values, const Space& space) {
  const std::string text = message_literal(values, space);
  return space.shape.empty() ? "{" + text + "}" : text;
}

}  // namespace

Space range_of(const Random& random, const Space& space) {
  Space range = space;
  if (random.kind == RandomSpec::Kind::uniform || random.kind == RandomSpec::Kind::log_uniform) {
    range.low = random.first;
    range.high = random.second;
  }
  return range;
}

View sample_lines(const Random& random, const Space& space, const std::string& field,
                  const std::string& constant) {
  const std::string type = message_type(space);
  std::vector<std::string> text;
  std::vector<std::string> choices;
  for (const auto& choice : random.choices) choices.push_back(message_literal(choice, space));
  switch (random.kind) {
    case RandomSpec::Kind::value:
      text = {fmt::format("states.{} = {}{};", field, type, initializer(random.first, space))};
      break;
    case RandomSpec::Kind::uniform:
      text = {fmt::format("states.{} = {}.sample(random);", field, constant)};
      break;
    case RandomSpec::Kind::log_uniform:
      text = {fmt::format("states.{} = eagerx::sample_log_uniform(random, {}.low, {}.high);", field,
                          constant, constant)};
      break;
    case RandomSpec::Kind::normal:
      text = {fmt::format("constexpr {} kMean{};", type, initializer(random.first, space)),
              fmt::format("constexpr {} kStd{};", type, initializer(random.second, space)),
              fmt::format("states.{} = {}.clipped(eagerx::sample_normal(random, kMean, kStd));",
                          field, constant)};
      break;
    case RandomSpec::Kind::choice:
      text = {fmt::format("constexpr {} kChoices[] = {};", type, braced(choices)),
              fmt::format("states.{} = eagerx::sample_choice(random, kChoices);", field)};
      break;
  }
  return lines_view(text);
}

}  // namespace eagerx::gen
