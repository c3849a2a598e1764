#include "generator/driver/commands/arguments.hpp"

#include <algorithm>
#include <utility>

#include "generator/frontend/read/quantity.hpp"
#include "generator/frontend/spec/format.hpp"

namespace eagerx::gen {
namespace {

Argument rate(std::string name, std::string about, std::optional<Rational>& rate_hz) {
  return checked(
      {std::move(name), std::move(about), "HZ",
       [&rate_hz](const auto& values) {
         rate_hz = parse_quantity(values.front(), Quantity::rate);
       }},
      [](const std::string& text) {
        const auto value = parse_quantity(text, Quantity::rate);
        return value && *value > Rational();
      },
      "is not a rate such as 30, 30Hz or 30000/1001");
}

/// Whether a part has a name that a graph file could give it: it becomes a folder.
bool is_split(const std::string& text) {
  const std::size_t equals = text.rfind('=');
  if (equals == std::string::npos || equals == 0 || equals + 1 == text.size()) return false;
  const std::string place = text.substr(equals + 1);
  const std::size_t colon = place.find(':');
  return colon == std::string::npos ||
         (is_identifier(place.substr(0, colon)) && colon + 1 < place.size());
}

}  // namespace

Arguments joined(std::initializer_list<Arguments> parts) {
  Arguments all;
  for (const Arguments& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

Argument graph(GraphOptions& options) {
  return required(reads(text("graph", options.graph, "the graph file", "GRAPH.yaml")));
}

Argument split(GraphOptions& options) {
  return checked(
      texts("--split", options.split,
            "split the graph into a program for Linux and one for each part, on a board or in "
            "another process (linux-sim); a part has nodes, `agent`, or `controller` (the agent "
            "and all other nodes). Replaces the graph's `placement:`; may be repeated",
            "NAME[,NAME...]=[PART:]TARGET"),
      is_split, "is not NAME[,NAME...]=TARGET or NAME[,NAME...]=PART:TARGET");
}

Arguments selection(GraphOptions& options) {
  return {variant(options), engine(options),
          choice("--real", {"float", "double"},
                 "floating-point type to use instead of the graph's `real:`",
                 [&options](const std::string& real) { options.real = real; }),
          texts("--target", options.targets,
                "target of the program; may be repeated (default: linux-sim)", "NAME"),
          split(options)};
}

Argument cut_out_nodes(GraphOptions& options, std::string about) {
  Argument argument{"--of", std::move(about), "NAME[,NAME...]", [&options](const auto& values) {
                      for (const std::string& value : values)
                        for (std::string& name : comma_separated(value))
                          options.of.push_back(std::move(name));
                    }};
  argument.repeated = true;
  argument.check = [](const std::string& text) {
    const bool complete = !text.empty() && !text.starts_with(',') && !text.ends_with(',') &&
                          text.find(",,") == std::string::npos;
    return complete ? std::string() : "`" + text + "` is not NAME[,NAME...]";
  };
  return argument;
}

Argument agent_policy(GraphOptions& options) {
  return reads(text("--policy", options.agent_policy,
                    "policy file to use instead of the graph's `agent:`", "FILE"));
}

Argument variant(GraphOptions& options) {
  return text("--variant", options.variant, "variant of the graph, a name of its `variants:`",
              "NAME");
}

Argument engine(GraphOptions& options) {
  return text("--engine", options.engine, "engine to use instead of the graph's", "NAME");
}

Arguments rates(GraphOptions& options) {
  return {rate("--rate", "rate of the environment to use instead of the graph's", options.rate_hz),
          rate("--engine-rate", "rate of the engine to use instead of the graph's",
               options.engine_rate_hz)};
}

Argument library(LibraryOptions& options) {
  return folder(texts("--path", options.paths,
                      "folder with your own entities or targets; may be repeated", "DIR"));
}

Argument quiet(MessageOptions& options) {
  return flag("-q,--quiet", options.quiet, "print problems only");
}

Arguments diagnostics(MessageOptions& options) {
  return {choice("--diagnostics", {"text", "json"}, "format of messages (default: text)",
                 [&options](const std::string& form) { options.json = form == "json"; }),
          quiet(options)};
}

Arguments on_building(GenerateOptions& options) {
  return joined(
      {{graph(options),
        folder(text("-o,--output", options.output,
                    "output folder, in whose folder `build` the program is built (default: "
                    "generated/<graph name>, followed by the name of another target, a variant, "
                    "engine or policy, such as generated/<graph name>-<target>)",
                    "DIR"))},
       selection(options),
       rates(options),
       {agent_policy(options), library(options), warnings(options)},
       {flag("--sanitize", options.sanitize,
             "for Linux: build with address and undefined-behavior sanitizers, in the folder "
             "`build-sanitized`; they name the class and the line of a node that writes beyond a "
             "message")},
       diagnostics(options)});
}

Argument warnings(GraphOptions& options) {
  return flag("--warnings-as-errors", options.warnings_as_errors,
              "treat warnings as errors: exit code 1, and nothing is written");
}

Argument handed_on(const std::string& name, std::string about, std::string type,
                   std::vector<std::string>& words) {
  return {name, std::move(about), std::move(type), [&words, name](const auto& values) {
            const std::string first = name.substr(0, name.find(','));
            if (values.empty()) words.push_back(first);
            for (const std::string& value : values) words.insert(words.end(), {first, value});
          }};
}

std::string check_one_target(const GraphOptions& options) {
  return options.targets.size() > 1 ? "one --target can be run at a time" : "";
}

}  // namespace eagerx::gen
