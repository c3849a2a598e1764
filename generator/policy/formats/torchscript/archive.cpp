#include "generator/policy/formats/torchscript/archive.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "generator/policy/network/limits.hpp"

namespace eagerx::gen {
namespace {

constexpr std::string_view kRebuild = "torch._utils._rebuild_tensor_v2";

/// A number of torch, which calculates with it as with a float.
std::optional<std::vector<float>> single_number(const StoredTensor& tensor) {
  PolicyProblem ignored;
  if (!tensor.shape.empty() || !fits("", tensor, ignored)) return std::nullopt;
  const auto value = static_cast<float>(values_of(tensor).front());
  return std::isfinite(value) ? std::optional(std::vector{value}) : std::nullopt;
}

/// Whole numbers that an observation is put into another order by.
bool is_list_of_places(const StoredTensor& tensor) {
  constexpr std::int64_t kMost = 4096;
  const bool is_whole = tensor.type == ElementType::int64 || tensor.type == ElementType::int32;
  return is_whole && tensor.shape.size() == 1 && tensor.shape.front() <= kMost;
}

}  // namespace

bool TorchArchive::open(PolicyProblem& problem) {
  for (const char* name : {"data.pkl", "constants.pkl"}) {
    const auto bytes = archive_.read(folder_ + name, buffers_.emplace_back(), problem);
    if (!bytes) return false;
    auto pickle = read_pickle(*bytes, PickleNames::program, problem);
    if (!pickle) return false;
    pickles_.push_back(std::move(*pickle));
  }
  return true;
}

std::optional<std::string_view> TorchArchive::storage(int which, std::string_view key,
                                                      PolicyProblem& problem) {
  const std::string name = fmt::format("{}{}/{}", folder_, which == 0 ? "data" : "constants", key);
  if (const auto known = storages_.find(name); known != storages_.end()) return known->second;
  const auto bytes = archive_.read(name, buffers_.emplace_back(), problem);
  if (!bytes) return std::nullopt;
  if (!count_unpacked(buffers_.back().size(), unpacked_, "use a smaller network", problem)) {
    return std::nullopt;
  }
  storages_.emplace(name, *bytes);
  return bytes;
}

const NetValue* TorchArchive::tensor(int which, std::uint32_t index, const std::string& name,
                                     PolicyProblem& problem) {
  const auto [place, fresh] = known_.try_emplace({which, index});
  NetValue& value = place->second;
  if (!fresh) {
    if (value.kind == NetValue::Kind::other) problem = value.problem;
    return value.kind == NetValue::Kind::other ? nullptr : &value;
  }
  value.kind = NetValue::Kind::other;
  const auto stored = rebuilt_tensor(
      pickle(which), pickle(which).at(index), name,
      [&](std::string_view key) { return storage(which, key, value.problem); }, value.problem);
  if (stored && is_list_of_places(*stored) && fits(name, *stored, value.problem)) {
    Integers places;
    for (const double number : values_of(*stored)) {
      places.push_back(static_cast<std::int64_t>(number));
    }
    value = integers_value(std::move(places), stored->shape);
    return &value;
  }
  auto numbers = stored ? single_number(*stored) : std::nullopt;
  if (stored && !numbers && fits(name, *stored, value.problem)) {
    numbers_ += static_cast<std::size_t>(element_count(stored->shape).value_or(0));
    if (numbers_ > static_cast<std::size_t>(kMaxParameters)) {
      value.problem = {"E0619", fmt::format("has more than {} parameters", kMaxParameters),
                       "use a smaller network"};
    } else {
      numbers = floats_of(name, *stored, value.problem);
    }
  }
  if (numbers) {
    value = constant_value(made_tensor(tensors_, name, *numbers, stored->shape));
    return &value;
  }
  problem = value.problem;
  return nullptr;
}

const TorchFunctions* TorchArchive::code(const std::string& module, PolicyProblem& problem) {
  if (const auto known = codes_.find(module); known != codes_.end()) return &known->second;
  std::string path = module;
  std::replace(path.begin(), path.end(), '.', '/');
  const std::string file = fmt::format("code/{}.py", path);
  std::string buffer;
  const auto text = archive_.read(folder_ + file, buffer, problem);
  auto functions = text ? parse_torch_code(*text, file, problem) : std::nullopt;
  if (!functions) return nullptr;
  return &codes_.emplace(module, std::move(*functions)).first->second;
}

const TorchFunction* TorchArchive::function(const std::string& module, const std::string& name,
                                            PolicyProblem& problem) {
  const TorchFunctions* functions = code(module, problem);
  if (functions == nullptr) return nullptr;
  if (const auto found = functions->find(name); found != functions->end()) return &found->second;
  return refuse(problem, "E0753",
                fmt::format("has no code of `{}` in `{}`", printable(name), printable(module)),
                "the file is damaged: export the actor again");
}

std::vector<std::int64_t> TorchArchive::sizes() const {
  std::set<std::int64_t> found;
  for (const Pickle& pickle : pickles_) {  // torch.jit.freeze() makes constants of all tensors
    for (const PickleValue& value : pickle.values) {
      if (!pickle.made_by(value, kRebuild)) continue;
      const std::vector<std::uint32_t>& arguments = pickle.at(value.arguments).items;
      if (arguments.size() < 3) continue;
      const auto shape = pickle.integers(&pickle.at(arguments[2]));
      for (const std::int64_t dim : shape.value_or(std::vector<std::int64_t>{})) {
        if (dim >= 1 && dim <= kMaxValues) found.insert(dim);
      }
    }
  }
  return {found.begin(), found.end()};
}

}  // namespace eagerx::gen
