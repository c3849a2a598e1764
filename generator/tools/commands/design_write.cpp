#include "generator/tools/commands/design_write.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <optional>

#include "generator/frontend/spec/reference.hpp"
#include "generator/support/diagnostics/search.hpp"
#include "generator/tools/edit/structure.hpp"
#include "generator/tools/serve/graph_file.hpp"

namespace eagerx::gen {
namespace {

/// A parameter of something that the text of the graph names.
struct TextParameter {
  std::string section, owner, name;
};

const YamlValue* in(const YamlValue* map, std::string_view key) {
  return map != nullptr ? map->find(key) : nullptr;
}

/// The parts of "leg/balance".
std::vector<std::string> owners_in(const std::string& node) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= node.size();) {
    const std::size_t end = std::min(node.find('/', begin), node.size());
    parts.push_back(node.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

class ParameterPlaces {
 public:
  ParameterPlaces(const Run& run, const std::string& node) : run_(run), parts_(owners_in(node)) {
    for (const char* const section : {"nodes", "objects"}) {
      const YamlValue* const found = in(in(&run.tree, section), parts_.front());
      if (found == nullptr) continue;
      section_ = section;
      types_.push_back(type_in(found));
    }
    // Those of composites, from the outside to the inside.
    for (std::size_t i = 1; i < parts_.size() && !types_.empty(); ++i)
      types_.push_back(type_in(inner(i)));
  }

  /// Nothing with why.
  std::optional<TextParameter> find(std::string name, std::string& why) const {
    if (section_.empty() || types_.size() != parts_.size()) {
      why = "the graph's file does not name its owner alone";
      return std::nullopt;
    }
    for (std::size_t i = parts_.size(); i-- > 1;) {
      const YamlValue* const value = in(in(inner(i), "config"), name);
      const auto reference = value != nullptr ? reference_in(*value) : std::nullopt;
      if (!reference || reference->what != "config" || !reference->part.empty()) {
        why = fmt::format("the manifest of `{}` does not hand a parameter of its own on to it",
                          types_[i - 1]);
        return std::nullopt;
      }
      name = reference->name;
    }
    return TextParameter{section_, parts_.front(), name};
  }

 private:
  static std::string type_in(const YamlValue* entry) {
    const YamlValue* const type = in(entry, "type");
    return type != nullptr ? type->text : std::string();
  }
  /// Part `i` in the manifest of the composite that it is in.
  [[nodiscard]] const YamlValue* inner(std::size_t i) const {
    const Entity* const outer = run_.library.find(types_[i - 1]);
    if (outer == nullptr || !outer->is_composite()) return nullptr;
    const YamlValue* const graph = outer->composite->find("graph");
    const YamlValue* const node = in(in(graph, "nodes"), parts_[i]);
    return node != nullptr ? node : in(in(graph, "objects"), parts_[i]);
  }

  const Run& run_;
  std::vector<std::string> parts_, types_;
  std::string section_;
};

/// Whether the node of another reading of the graph has the values.
bool has_values(const Graph& graph, const std::string& node,
                const std::vector<DesignedParameter>& parameters) {
  const auto found = ranges::find(graph.nodes, node, &GraphNode::name);
  return found != graph.nodes.end() &&
         std::ranges::all_of(parameters, [&](const DesignedParameter& each) {
           return parameter_of(found->config, each.name) == each.values;
         });
}

OutlinePath path_of(const TextParameter& place, const std::string& text,
                    const std::string& variant) {
  const OutlinePath of_variant = {std::string("variants"), variant,   place.section, place.owner,
                                  std::string("config"),   place.name};
  if (!variant.empty() && node_at(outline_of(text), of_variant) != nullptr) return of_variant;
  return {place.section, place.owner, std::string("config"), place.name};
}

}  // namespace

void set_parameters(GraphNode& node, const std::vector<DesignedParameter>& parameters) {
  for (const DesignedParameter& each : parameters) {
    const auto found = std::ranges::find_if(node.config, [&](const ConfigValue& value) {
      return value.parameter->name.value == each.name;
    });
    if (found == node.config.end()) continue;
    if (auto* const list = std::get_if<std::vector<double>>(&found->value)) *list = each.values;
    if (auto* const number = std::get_if<double>(&found->value)) *number = each.values.front();
    found->given = true;
  }
}

std::vector<double> parameter_of(const Config& config, const std::string& name) {
  const auto found = std::ranges::find_if(
      config, [&](const ConfigValue& value) { return value.parameter->name.value == name; });
  if (found == config.end()) return {};
  if (const auto* const list = std::get_if<std::vector<double>>(&found->value)) return *list;
  if (const auto* const number = std::get_if<double>(&found->value)) return {*number};
  if (const auto* const whole = std::get_if<std::int64_t>(&found->value))
    return {static_cast<double>(*whole)};
  return {};
}

void write_parameters(Run& run, const GraphOptions& options, const std::string& node,
                      const std::vector<DesignedParameter>& parameters) {
  std::ifstream file(options.graph, std::ios::binary);
  const std::string before(std::istreambuf_iterator<char>(file), {});
  const ParameterPlaces places(run, node);
  std::string text = before;
  const auto refuse = [&](const std::string& why, const std::string& help) {
    auto& error = run.diagnostics.error(
        "E0523", run.graph->span,
        fmt::format("the parameters of `{}` cannot be written: {}", node, why));
    error.help = help.empty() ? "copy them to where they belong" : help;
  };
  for (const DesignedParameter& each : parameters) {
    std::string why;
    const auto place = places.find(each.name, why);
    if (!place) return refuse(why, "");
    const Change change = set_value(text, path_of(*place, text, options.variant), each.text());
    if (!change.edit) return refuse(change.problem, change.help);
    text = applied(text, change.edit->splices);
  }
  Run after;
  if (!make_of_text(after, options, text) || !has_values(*after.graph, node, parameters))
    return refuse("another place of the graph overrides them", "");
  serve::GraphFile target(options.graph);
  const auto written = target.write(before, text);
  if (written == serve::GraphFile::Written::done) return;
  const bool has_changed = written == serve::GraphFile::Written::changed;
  run.diagnostics.io_error(
      "E0901", {},
      fmt::format("cannot write `{}`: {}", options.graph,
                  has_changed ? "another program has changed it meanwhile" : target.problem()));
}

}  // namespace eagerx::gen
