#include "generator/frontend/library/parameters.hpp"

#include <fmt/format.h>

#include "generator/frontend/library/manifest_values.hpp"
#include "generator/frontend/read/number.hpp"
#include "generator/frontend/read/scalar.hpp"
#include "generator/frontend/spec/reference.hpp"

namespace eagerx::gen {
namespace {

Parameter::Type parameter_type(const std::string& word) {
  if (word == "int") return Parameter::Type::integer;
  if (word == "float") return Parameter::Type::number;
  if (word == "bool") return Parameter::Type::boolean;
  if (word == "string") return Parameter::Type::text;
  if (word == "enum") return Parameter::Type::keyword;
  if (word == "model") return Parameter::Type::model;
  return word == "ints" ? Parameter::Type::integers : Parameter::Type::numbers;
}

/// Whole numbers as such: not all of them are doubles.
std::optional<ConditionNumber> bound_at(const YamlValue& yaml, const char* key) {
  const YamlValue* value = yaml.find(key);
  if (value == nullptr) return std::nullopt;
  if (const auto whole = parse_int(value->text)) return *whole;
  const auto number = parse_number(value->text);
  return number ? std::optional<ConditionNumber>(*number) : std::nullopt;
}

/// Options are enumerators of the class of the same manifest.
void check_options(const YamlValue& options, Diagnostics& diagnostics) {
  for (const auto& option : options.items) {
    if (is_identifier(option.text)) continue;
    diagnostics
        .error("E0205", option.span,
               fmt::format("{} is not the name of an enumerator", describe(option)))
        .help = "options are the enumerators of `class`, as C++ has them";
  }
}

void refuse_bounds_without_numbers(const YamlValue::Entry& parameter, Parameter::Type type,
                                   Diagnostics& diagnostics) {
  const bool numbers = type != Parameter::Type::boolean && type != Parameter::Type::text &&
                       type != Parameter::Type::keyword && type != Parameter::Type::model;
  for (const char* key : {"low", "high"}) {
    const YamlValue* bound = parameter.value.find(key);
    if (numbers || bound == nullptr) continue;
    diagnostics
        .error("E0208", bound->span,
               fmt::format("`{}` does nothing for `{}`, which is not a number", key, parameter.key))
        .help = "leave it out";
  }
}

/// A state is a number or a list of them, and only nodes take those of their parameters.
void check_tunable(const Parameter& parameter, const YamlValue& root, Diagnostics& diagnostics) {
  const bool number =
      parameter.type == Parameter::Type::number || parameter.type == Parameter::Type::numbers;
  const bool node = text_at(root, "kind") == "node" && root.find("graph") == nullptr;
  const YamlValue* states = root.find("states");
  const bool twice = states != nullptr && states->find(parameter.name.value) != nullptr;
  if (!parameter.tunable || (number && node && !twice)) return;
  diagnostics.error(
      "E0206", parameter.name.span,
      twice ? fmt::format("`{}` is a state of its own and cannot be tunable", parameter.name.value)
            : fmt::format("`{}` cannot be tunable: only numbers of nodes with a class are",
                          parameter.name.value));
}

}  // namespace

void add_tunable_states(Entity& entity) {
  for (const Parameter& parameter : entity.config) {
    if (!parameter.tunable) continue;
    const Span span = parameter.name.span;
    const auto bound = [&](const std::optional<ConditionNumber>& value) {
      return value ? std::optional(made_number(*value, span)) : std::nullopt;
    };
    PortManifest state;
    state.name = parameter.name;
    state.unit = parameter.unit;
    state.about = parameter.about;
    state.eagerx = parameter.name.value;
    state.space.span = span;
    state.space.dtype = Spanned<std::string>{"float32", span};
    std::vector<YamlValue> shape;
    if (parameter.type == Parameter::Type::numbers)
      shape.push_back(made_reference({"size", parameter.name.value}, span));
    state.space.shape = made_list(std::move(shape), span);
    state.optional = true;
    state.tunes_running = parameter.tunes_running;
    state.space.low = bound(parameter.low);
    state.space.high = bound(parameter.high);
    entity.states.push_back(std::move(state));
  }
}

std::vector<Parameter> read_parameters(const YamlValue& root, Diagnostics& diagnostics) {
  std::vector<Parameter> result;
  const YamlValue* map = root.find("config");
  if (map == nullptr) return result;
  for (const auto& entry : map->entries) {
    Parameter parameter;
    parameter.name = {entry.key, entry.key_span};
    parameter.type = parameter_type(text_at(entry.value, "type"));
    parameter.unit = text_at(entry.value, "unit");
    parameter.about = text_at(entry.value, "about");
    parameter.fallback = value_at(entry.value, "default");
    parameter.low = bound_at(entry.value, "low");
    parameter.high = bound_at(entry.value, "high");
    parameter.options = texts_at(entry.value, "options");
    parameter.cpp_class = text_at(entry.value, "class");
    if (const YamlValue* name = entry.value.find("class")) check_class(*name, diagnostics);
    const YamlValue* eagerx = entry.value.find("eagerx");
    parameter.eagerx = eagerx != nullptr ? eagerx->text : entry.key;
    if (const YamlValue* options = entry.value.find("options"))
      check_options(*options, diagnostics);
    const bool keyword = parameter.type == Parameter::Type::keyword;
    if (keyword != !parameter.options.empty() || keyword != !parameter.cpp_class.empty()) {
      diagnostics.error(
          "E0206", entry.key_span,
          fmt::format("`{}`: an enum, and only an enum, has `options` and a `class`", entry.key));
    }
    parameter.engine = text_at(entry.value, "engine");
    if ((parameter.type == Parameter::Type::model) == parameter.engine.empty()) {
      diagnostics.error("E0206", entry.key_span,
                        fmt::format("`{}`: a model, and only a model, has an `engine`", entry.key));
    }
    if (parameter.type == Parameter::Type::model && text_at(root, "kind") == "object") {
      diagnostics.error("E0206", entry.key_span,
                        fmt::format("`{}`: a parameter of an object cannot be a model", entry.key));
    }
    refuse_bounds_without_numbers(entry, parameter.type, diagnostics);
    parameter.tunes_running = text_at(entry.value, "tunable") == "running";
    parameter.tunable = parameter.tunes_running || text_at(entry.value, "tunable") == "true";
    check_tunable(parameter, root, diagnostics);
    result.push_back(std::move(parameter));
  }
  return result;
}

}  // namespace eagerx::gen
