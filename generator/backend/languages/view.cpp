#include "generator/backend/languages/view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>
#include <string_view>

#include "generator/backend/emit/namer.hpp"
#include "generator/backend/languages/timetable.hpp"
#include "generator/support/diagnostics/join.hpp"
#include "generator/support/diagnostics/search.hpp"
#include "generator/support/quote/quote.hpp"

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

/// Foreign text for a docstring or a comment of any language.
std::string plain_text(const std::string& text) {
  std::string result = in_comment(text);
  std::ranges::replace_if(
      result, [](char c) { return c == '"' || c == '\\'; }, '\'');
  return result;
}

std::string numpy_name(Dtype dtype) {
  return dtype == Dtype::boolean ? "bool_" : std::string(to_string(dtype));
}

/// "()", "(2,)", "(64, 64, 3)"
std::string tuple(const Space& space) {
  return fmt::format("({}{})", join(space.shape, ", "), space.shape.size() == 1 ? "," : "");
}

std::string c_type(Dtype dtype) {
  const std::string type(element_type(dtype));
  return type.starts_with("std::") ? type.substr(std::string_view("std::").size()) : type;
}
/// "[64][64][3]"
std::string dimensions(const Space& space) {
  std::string text;
  for (const std::uint64_t size : space.shape) text += fmt::format("[{}]", size);
  return text;
}

/// Of "0.2.1", as greetings say it: major * 256 + minor.
std::string runtime_number(const std::string& version) {
  constexpr int kMajor = 256;
  return fmt::format("{}", std::atoi(version.c_str()) * kMajor +
                               std::atoi(version.c_str() + version.find('.') + 1));
}

std::string count_text(const Input& input) {
  const std::string count = input.window == 0   ? "those that are new"
                            : input.window == 1 ? "the newest"
                                                : fmt::format("the last {}", input.window);
  return count + (input.skip ? "; none at n = 0" : "");
}

constexpr std::string_view kPython = ".py";

class LanguageView {
 public:
  LanguageView(const Plan& plan, const PartLayout& layout)
      : plan_(plan), graph_(*plan.graph), layout_(layout) {}

  View run(std::uint64_t hash, const std::string& version) {
    const PlacedPart& part = graph_.placement->parts[layout_.part];
    const PartLink& link = plan_.split->links[layout_.part];
    View view = object();
    view.set("name", graph_.name);
    view.set("part", plain_text(part.name));
    view.set("version", version);
    view.set("runtime", runtime_number(version));
    view.set("hash", fmt::format("0x{:016x}", hash));
    view.set("most_to_part", fmt::format("{}", link.part_payload));
    view.set("depth", fmt::format("{}", link.depth));
    view.set("most_to_hub", fmt::format("{}", link.hub_payload));
    View nodes = list(), blanks = list(), imports = list();
    for (const auto* turns : {&layout_.before, &layout_.after}) {
      for (const LayoutTurn& turn : *turns) {
        if (!turn.runs) continue;
        View item = node(turn.node, *part.target);
        nodes.push_back(item);
        if (!is_imported(*part.target, graph_.nodes[turn.node])) {
          blanks.push_back(item);
        } else if (imported_.insert(graph_.nodes[turn.node].entity).second) {
          imports.push_back(item);
        }
      }
    }
    view.set("has_blanks", blanks.is_non_empty_list());
    view.set("has_imports", imports.is_non_empty_list());
    view["nodes"] = std::move(nodes);
    view["blanks"] = std::move(blanks);
    view["imports"] = std::move(imports);
    add_timetable(plan_, layout_, c_names_, view);
    return view;
  }

 private:
  View node(std::size_t n, const Target& target) {
    const GraphNode& node = graph_.nodes[n];
    View view = object();
    view.set("node", node.name);
    view.set("c_name", c_names_[n] = c_unique_.unique(snake(node.name)));
    const std::string file = fs::path(node.entity->python).stem().string();
    const bool imported = is_imported(target, node);
    view.set("module", imported ? file : "");
    view.set("class",
             imported ? file + "." + node.entity->id.value : classes_.unique(camel(node.name)));
    view.set("entity", node.entity->id.value);
    view.set("rate", node.rate_hz.to_string());
    std::vector<std::string> parameters;
    for (const ConfigValue& value : node.config) parameters.push_back(value.parameter->name.value);
    view.set("config", parameters.empty() ? "none" : fmt::format("{}", join(parameters, ", ")));
    std::string states, arguments;
    for (const State& state : node.states)
      if (state.random) states += ", " + state.name;
    for (const Input& input : node.inputs) arguments += ", " + input.name;
    view.set("states", states);
    view.set("arguments", arguments);
    view["inputs"] = inputs(n);
    view["outputs"] = outputs(n);
    view.set("several", node.outputs.size() != 1);
    view.set("zeros", node.outputs.size() == 1 ? zeros(node.outputs.front().space) : "");
    return view;
  }

  static std::string zeros(const Space& space) {
    return fmt::format("np.zeros({}, np.{})", tuple(space), numpy_name(space.dtype));
  }

  View port(const std::string& name, const Space& space, std::size_t message) const {
    View view = object();
    view.set("field", name);
    const std::string type = c_type(space.dtype), dims = dimensions(space);
    view.set("dims", dims);
    view.set("window_type", type);
    view.set("member", fmt::format("{} {}{}", type, name, dims));
    view.set("pointer", dims.empty() ? fmt::format("const {}* {}", type, name)
                                     : fmt::format("const {} (*{}){}", type, name, dims));
    view.set("cast", dims.empty() ? fmt::format("(const {}*)", type)
                                  : fmt::format("(const {} (*){})", type, dims));
    view.set("message", fmt::format("{}", message));
    view.set("dtype", std::string(to_string(space.dtype)));
    view.set("shape", fmt::format("{}", join(space.shape, ", ")));
    view.set("window",
             space.shape.empty() ? "[n]" : fmt::format("[n, {}]", join(space.shape, ", ")));
    const std::string& unit = layout_.messages[message].unit;
    view.set("unit", unit.empty() ? "" : " in " + plain_text(unit));
    view.set("zeros", zeros(space));
    return view;
  }

  View inputs(std::size_t n) const {
    View views = list();
    const GraphNode& node = graph_.nodes[n];
    for (std::size_t i = 0; i < node.inputs.size(); ++i) {
      const Input& input = node.inputs[i];
      const Reception& reception = plan_.nodes[n].receptions[i];
      View view = port(input.name, input.space,
                       layout_.find(plan_, input.source_node, input.source_output));
      view.set("from", name_of_source(graph_, input));
      view.set("count", count_text(input));
      view.set("window_name", fmt::format("window_{}_{}", c_names_.at(n), input.name));
      view.set("window_size", fmt::format("{}", input.window));
      view.set("most", fmt::format("{}", reception.max_size));
      view.set("skip", input.skip ? "1" : "0");
      view.set("a", fmt::format("{}", reception.a));
      view.set("b", fmt::format("{}", reception.b));
      view.set("x", fmt::format("{}", reception.x));
      view.set("off", fmt::format("{}", reception.off));
      views.push_back(view);
    }
    return views;
  }

  View outputs(std::size_t n) const {
    View views = list();
    for (std::size_t o = 0; o < graph_.nodes[n].outputs.size(); ++o) {
      const Output& output = graph_.nodes[n].outputs[o];
      views.push_back(port(output.name, output.space, layout_.find(plan_, n, o)));
    }
    return views;
  }

  const Plan& plan_;
  const Graph& graph_;
  const PartLayout& layout_;
  Names classes_, c_unique_;
  std::map<std::size_t, std::string> c_names_;  // by node
  std::set<const Entity*> imported_;
};

}  // namespace

bool is_imported(const Target& target, const GraphNode& node) {
  return !node.entity->python.empty() && ranges::any_of(target.yours, [](const auto& item) {
    return item.second.ends_with(kPython);
  });
}

bool is_module(const std::string& file) {
  const std::string_view stem = std::string_view(file).substr(0, file.rfind('.'));
  const auto in_word = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; };
  return file.ends_with(kPython) && !stem.empty() && std::isdigit(stem.front()) == 0 &&
         ranges::all_of(stem, in_word);
}

View language_view(const Plan& plan, const PartLayout& layout, std::uint64_t hash,
                   const std::string& version) {
  return LanguageView(plan, layout).run(hash, version);
}

}  // namespace eagerx::gen
