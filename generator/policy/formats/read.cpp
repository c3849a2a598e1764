// Reads a file, and calls the reader of its format.
#include "generator/policy/formats/read.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <string>

#include "generator/policy/formats/actor/files.hpp"
#include "generator/policy/formats/common/foreign.hpp"
#include "generator/policy/formats/files.hpp"
#include "generator/policy/formats/onnx/read_onnx.hpp"
#include "generator/policy/formats/partial_statistics.hpp"
#include "generator/policy/formats/statistics.hpp"
#include "generator/policy/formats/tensors/containers.hpp"
#include "generator/policy/formats/torchscript/read_torchscript.hpp"
#include "generator/support/files/missing_file.hpp"

namespace eagerx::gen {
namespace {

bool is_safetensors(std::string_view bytes) {
  constexpr std::size_t kLength = 8;
  return bytes.size() > kLength && bytes[kLength] == '{' && bytes[kLength - 1] == '\0';
}

PolicyProblem none_of_the_formats() {
  return {"E0603", "has none of the supported formats", kKnownFormats};
}

/// TorchScript says every step itself.
std::optional<Network> read_program(const Archive& archive, const ReadContext& context,
                                    PolicyProblem& problem) {
  const char* said = !context.actor.empty()      ? "actor"
                     : context.activation        ? "activation"
                     : context.output_activation ? "output_activation"
                     : !context.layers.empty()   ? "layers"
                                                 : nullptr;
  if (said != nullptr) {
    return refuse(problem, "E0626", "is TorchScript, which says every step of the actor",
                  fmt::format("leave the graph's `{}` out", said));
  }
  return read_torchscript(archive, context, problem);
}

std::optional<Network> read_any(std::string_view bytes, const ReadContext& context,
                                PolicyProblem& problem) {
  if (bytes.empty()) return refuse(problem, "E0603", "is empty", kKnownFormats);
  const bool is_zip = bytes.starts_with("PK\x03\x04");
  std::optional<Archive> archive;
  if (is_zip && !(archive = Archive::open(bytes, problem))) return std::nullopt;
  if (archive && is_torchscript(*archive)) return read_program(*archive, context, problem);
  if (!context.input_sizes.empty()) {
    return refuse(problem, "E0626", "is not TorchScript, whose inputs alone have no sizes",
                  "leave the graph's `input_sizes` out");
  }
  const bool is_table = is_zip || is_safetensors(bytes) || is_legacy_torch(bytes);
  if (is_table && !context.output_name.empty()) {
    return refuse(problem, "E0751", "is a table of tensors, which has no outputs with names",
                  "leave the graph's `output_name` out: only ONNX and TorchScript have such");
  }
  if (archive) return read_zip_policy(*archive, context, problem);
  if (is_safetensors(bytes)) return read_safetensors(bytes, context, problem);
  if (is_legacy_torch(bytes)) return read_legacy_torch_policy(bytes, context, problem);
  if (auto other = foreign_file(bytes)) {
    problem = std::move(*other);
    return std::nullopt;
  }
  if (!context.actor.empty()) {
    return refuse(problem, "E0625", "is not a table of tensors, which may hold several actors",
                  "leave the graph's `actor` out; of ONNX say `output_name`");
  }
  if (!context.layers.empty()) {
    return refuse(problem, "E0626",
                  "is not a table of tensors, which alone says nothing of their order",
                  "leave the graph's `layers` out");
  }
  auto network = read_onnx(bytes, context.output_name, context.files, problem);
  if (network && (context.activation || context.output_activation)) {
    return refuse(problem, "E0626", "is ONNX, which defines the activation of every layer",
                  fmt::format("leave the graph's `{}` out",
                              context.activation ? "activation" : "output_activation"));
  }
  // The reader of ONNX comes last: what it does not recognize is unknown.
  if (!network && problem.code == "E0603") problem = none_of_the_formats();
  return network;
}

/// Leaves the deviations out, which are the second half of the outputs: rsl_rl's MLP gives
/// [2, actions], and its policy acts by the first row (rsl_rl/modules/distribution.py,
/// HeteroscedasticGaussianDistribution.deterministic_output).
bool keep_means(Network& network, PolicyProblem& problem) {
  const std::uint32_t outputs = network.outputs();
  if (outputs % 2 != 0)
    return refuse(problem, "E0626",
                  fmt::format("gives {}, which are not means and as many deviations",
                              counted(outputs, "number")),
                  "leave the graph's `state_dependent_std` out");
  Layer& last = network.layers.back();
  const std::uint32_t means = outputs / 2;
  if (last.is_dense() && !last.norm) {
    last.weights.resize(std::size_t{means} * last.inputs);
    last.bias.resize(std::min<std::size_t>(last.bias.size(), means));
    last.outputs = means;
    return true;
  }
  Reorder first;
  for (std::uint32_t i = 0; i < means; ++i) first.from.push_back(i);
  network.layers.push_back(layer_of(std::move(first), outputs, means));
  return true;
}

/// "`angle` (2), `speed` (1)"
std::string listed(const std::vector<NamedPart>& parts) {
  std::string text;
  for (const NamedPart& part : parts) {
    text += fmt::format("{}`{}` ({})", text.empty() ? "" : ", ", printable(part.name), part.size);
  }
  return text;
}

/// True also if one of them does not say.
bool same_order(const std::vector<NamedPart>& a, const std::vector<NamedPart>& b) {
  return a.empty() || b.empty() ||
         std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const NamedPart& x, const NamedPart& y) { return x.name == y.name; });
}

/// Whether `statistics` are those of `network`: E0627, E0631.
bool check_normalization(Normalization& statistics, Network& network, const std::string& policy,
                         PolicyProblem& problem) {
  const bool is_partial = are_partial(statistics, network);
  if (is_partial && !complete_statistics(statistics, network, policy, problem)) return false;
  if (statistics.mean.size() != network.inputs()) {
    return refuse(problem, "E0627",
                  fmt::format("normalise {} numbers, but the policy `{}` takes {}",
                              statistics.mean.size(), policy, network.inputs()),
                  statistics.parts.empty() || !network.contract.observations.empty()
                      ? "name the statistics that were saved with this policy"
                      : "name the statistics that were saved with this policy; if they are of some "
                        "parts only (`norm_obs_keys`), give Stable-Baselines3's zip as the policy: "
                        "it says where these parts are");
  }
  if (!same_order(statistics.parts, network.contract.observations)) {
    return refuse(problem, "E0627",
                  fmt::format("are of {}, but the policy `{}` takes {}", listed(statistics.parts),
                              policy, listed(network.contract.observations)),
                  "name the statistics that were saved with this policy: parts that they lack "
                  "(`norm_obs_keys`) stay as they are, but all of theirs must be the policy's, in "
                  "its order");
  }
  const auto& own = network.normalization;
  if (own && (own->mean != statistics.mean || own->variance != statistics.variance)) {
    return refuse(problem, "E0631",
                  fmt::format("differ from those that the policy `{}` holds itself", policy),
                  "leave `normalize` out, or name the file that belongs to the policy");
  }
  return is_partial || network.contract.choices.empty() ||
         refuse(problem, "E0627",
                fmt::format("normalise what the policy `{}` takes as choices, which stay whole "
                            "numbers",
                            policy),
                "leave `normalize` out");
}

/// Adds the statistics that the graph names. False if they cannot be read or do not fit.
bool add_normalization(const PolicyRequest& request, Network& network, Diagnostics& diagnostics) {
  const auto bytes = read_bytes(request.normalize_path, request.normalize_name,
                                request.normalize_span, "statistics", diagnostics);
  if (!bytes) return false;
  PolicyProblem problem;
  auto statistics = read_statistics(*bytes, problem);
  if (!statistics || !check_normalization(*statistics, network, request.name, problem)) {
    report_problem(problem, "statistics", request.normalize_name, request.normalize_span,
                   diagnostics);
    return false;
  }
  network.normalization = std::move(statistics);
  network.normalization->source = request.normalize_name;
  return true;
}

}  // namespace

std::optional<Network> read_policy_bytes(std::string_view bytes, const std::string& name,
                                         Span mention, Diagnostics& diagnostics,
                                         const ReadContext& context) {
  PolicyProblem problem;
  std::optional<Network> network = read_any(bytes, context, problem);
  if (network && context.state_dependent_std && !keep_means(*network, problem)) network.reset();
  if (!network) {
    report_problem(problem, "policy", name, mention, diagnostics);
    return std::nullopt;
  }
  network->file = name;
  if (network->normalization) network->normalization->source = name;
  // A file that chooses, and does not say that it makes several choices, makes one.
  if (network->action == ActionKind::argmax) network->contract.groups = network->groups();
  return network;
}

std::optional<Network> read_policy(const PolicyRequest& request, Diagnostics& diagnostics) {
  if (const auto folder = foreign_folder(entries_of_folder(request.path))) {
    report_problem(*folder, "policy", request.name, request.span, diagnostics);
    return std::nullopt;
  }
  const auto bytes = read_bytes(request.path, request.name, request.span, "policy", diagnostics);
  if (!bytes) return std::nullopt;
  ReadContext context = request.context;
  if (!context.files) context.files = files_in_folder_of(request.path);
  auto network = read_policy_bytes(*bytes, request.name, request.span, diagnostics, context);
  if (!network) return std::nullopt;
  if (!request.normalize_path.empty() && !add_normalization(request, *network, diagnostics)) {
    return std::nullopt;
  }
  return network;
}

std::optional<Network> read_policy(const std::string& path, const std::string& name, Span mention,
                                   Diagnostics& diagnostics) {
  PolicyRequest request;
  request.path = path;
  request.name = name;
  request.span = mention;
  return read_policy(request, diagnostics);
}

}  // namespace eagerx::gen
