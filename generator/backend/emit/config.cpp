#include "generator/backend/emit/config.hpp"

#include <fmt/format.h>

#include "generator/backend/emit/literals.hpp"
#include "generator/support/quote/quote.hpp"

namespace eagerx::gen {
namespace {

struct ConfigWriter {
  const Parameter& parameter;

  CppValue operator()(std::int64_t value) const { return {int_type(value), int_literal(value)}; }
  CppValue operator()(double value) const { return {"double", double_literal(value)}; }
  CppValue operator()(bool value) const { return {"bool", bool_literal(value)}; }
  CppValue operator()(const std::string& value) const {
    if (parameter.type == Parameter::Type::keyword)
      return {"auto", from_global_namespace(parameter.cpp_class) + "::" + value};
    return {"const char*", cpp_string(value)};
  }
  /// Its class with the values that it is compiled for; as code it is a struct (model_view).
  CppValue operator()(const std::shared_ptr<const ModelUse>& model) const {
    std::vector<std::string> values;
    for (const ConfigValue& item : model->config) values.push_back(cpp_value(item).value);
    return {"", from_global_namespace(model->implementation->model.name) + braced(values)};
  }
  CppValue operator()(const std::vector<std::int64_t>& values) const {
    std::string type = "int";
    std::vector<std::string> literals;
    for (const std::int64_t value : values) {
      if (int_type(value) != "int") type = "std::int64_t";
      literals.push_back(int_literal(value));
    }
    return {fmt::format("std::array<{}, {}>", type, values.size()), braced(literals)};
  }
  CppValue operator()(const std::vector<double>& values) const {
    std::vector<std::string> literals;
    literals.reserve(values.size());
    for (const double value : values) literals.push_back(double_literal(value));
    return {fmt::format("std::array<double, {}>", values.size()), braced(literals)};
  }
};

}  // namespace

CppValue cpp_value(const ConfigValue& item) {
  return std::visit(ConfigWriter{*item.parameter}, item.value);
}

}  // namespace eagerx::gen
