#include "generator/policy/formats/actor/files.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <map>

#include "generator/policy/formats/actor/actor.hpp"
#include "generator/policy/formats/tensors/archive.hpp"
#include "generator/policy/formats/tensors/containers.hpp"

namespace eagerx::gen {
namespace {

/// Reads a file of torch.save in either of its formats.
bool read_torch_bytes(std::string_view bytes, bool all, TensorTable& table,
                      PolicyProblem& problem) {
  if (is_legacy_torch(bytes)) return read_legacy_torch(bytes, all, table, problem);
  const auto archive = Archive::open(bytes, problem);
  return archive && read_torch(*archive, all, table, problem);
}

/// The actor among the tensors, which is the one whose names begin with what the graph says.
std::optional<Network> make_said_actor(TensorTable& table, const PolicyFacts& facts,
                                       const ReadContext& context, PolicyProblem& problem) {
  if (context.actor.empty()) return make_actor(table, facts, context, problem);
  std::map<std::string, StoredTensor, std::less<>> chosen;
  const std::string prefix = context.actor + (context.actor.ends_with('.') ? "" : ".");
  for (auto& [name, tensor] : table.tensors) {
    if (name.starts_with(prefix)) chosen.emplace(name.substr(prefix.size()), std::move(tensor));
  }
  if (chosen.empty()) {
    const std::string first = table.tensors.empty() ? "none" : table.tensors.begin()->first;
    return refuse(problem, "E0625",
                  fmt::format("has no tensor whose name begins with `{}`; its first one is `{}`",
                              printable(prefix), printable(first)),
                  "leave `actor` out, or name one of its parts");
  }
  table.tensors = std::move(chosen);
  return make_actor(table, facts, context, problem);
}

}  // namespace

std::optional<Network> read_safetensors(std::string_view bytes, const ReadContext& context,
                                        PolicyProblem& problem) {
  TensorTable table;
  if (!read_safetensors_table(bytes, table, problem)) return std::nullopt;
  auto facts = facts_of_notes(table, problem);
  if (!facts) return std::nullopt;
  facts->format = "safetensors";
  return make_said_actor(table, *facts, context, problem);
}

std::optional<Network> read_legacy_torch_policy(std::string_view bytes, const ReadContext& context,
                                                PolicyProblem& problem) {
  TensorTable table;
  if (!read_legacy_torch(bytes, !context.actor.empty(), table, problem)) return std::nullopt;
  auto facts = facts_of_notes(table, problem);
  if (!facts) return std::nullopt;
  facts->format = "torch.save before 1.6";
  return make_said_actor(table, *facts, context, problem);
}

std::optional<Network> read_zip_policy(const Archive& archive, const ReadContext& context,
                                       PolicyProblem& problem) {
  TensorTable table;
  PolicyFacts facts;
  std::string policy_buffer;
  if (archive.has("policy.pth")) {
    const auto inner_bytes = archive.read("policy.pth", policy_buffer, problem);
    if (!inner_bytes) return std::nullopt;
    if (!read_torch_bytes(*inner_bytes, !context.actor.empty(), table, problem))
      return std::nullopt;
    std::string data_buffer;
    const auto data = archive.read("data", data_buffer, problem);
    if (!data) return std::nullopt;
    auto said = facts_of_sb3(*data, problem);
    if (!said) return std::nullopt;
    facts = std::move(*said);
    std::string version_buffer;
    PolicyProblem ignored;
    const auto version = archive.read("_stable_baselines3_version", version_buffer, ignored);
    facts.format = "Stable-Baselines3";
    if (version && !version->empty()) {
      facts.format += " " + printable(version->substr(0, version->find('\n')));
    }
    return make_said_actor(table, facts, context, problem);
  }
  const std::vector<std::string> names = archive.names();
  const bool is_npz = std::any_of(names.begin(), names.end(),
                                  [](const std::string& name) { return name.ends_with(".npy"); });
  if (is_npz ? !read_npz(archive, table, problem)
             : !read_torch(archive, !context.actor.empty(), table, problem)) {
    return std::nullopt;
  }
  auto said = facts_of_notes(table, problem);
  if (!said) return std::nullopt;
  said->format = is_npz ? "npz" : "torch.save";
  return make_said_actor(table, *said, context, problem);
}

}  // namespace eagerx::gen
