#include "generator/policy/formats/tensors/tensor.hpp"

#include <fmt/core.h>

namespace eagerx::gen {
namespace {

constexpr std::size_t kMaxTensors = 100'000;
constexpr std::size_t kMaxTensorRank = 16;

/// Elements from the first to the last one, plus one; nothing if a stride is negative or huge.
std::optional<std::int64_t> extent(const StoredTensor& tensor) {
  const auto count = element_count(tensor.shape);
  if (!count || tensor.strides.empty() || *count == 0) return count;
  if (tensor.strides.size() != tensor.shape.size()) return std::nullopt;
  std::int64_t last = 0;
  for (std::size_t i = 0; i < tensor.shape.size(); ++i) {
    const std::int64_t steps = tensor.shape[i] - 1;
    const std::int64_t stride = tensor.strides[i];
    if (stride < 0 || stride > kMaxElements || (steps > 0 && stride > kMaxElements / steps)) {
      return std::nullopt;
    }
    last += steps * stride;
    if (last > kMaxElements) return std::nullopt;
  }
  return last + 1;
}

}  // namespace

bool fits(const std::string& name, const StoredTensor& tensor, PolicyProblem& problem) {
  const auto elements = extent(tensor);
  const std::size_t held = tensor.bytes.size() / size_of(tensor.type);
  if (elements && tensor.shape.size() <= kMaxTensorRank &&
      static_cast<std::uint64_t>(*elements) <= held &&
      element_count(tensor.shape) <= kMaxElements) {
    // Strides of zero would let a few bytes stand for a terabyte.
    if (static_cast<std::uint64_t>(*element_count(tensor.shape)) <= held) return true;
  }
  return refuse(problem, "E0614",
                fmt::format("says that tensor `{}` has shape {}, but holds {} values",
                            printable(name), show(tensor.shape), held),
                kSaveAgain);
}

std::vector<double> values_of(const StoredTensor& tensor) {
  const std::size_t size = size_of(tensor.type);
  const auto count = static_cast<std::size_t>(element_count(tensor.shape).value_or(0));
  std::vector<double> values(count);
  std::vector<std::int64_t> at(tensor.shape.size(), 0);
  std::int64_t place = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t offset = tensor.strides.empty() ? i : static_cast<std::size_t>(place);
    values[i] = value_at(tensor.type, tensor.bytes.data() + offset * size);
    for (std::size_t d = at.size(); !tensor.strides.empty() && d-- > 0;) {
      place += tensor.strides[d];
      if (++at[d] < tensor.shape[d]) break;
      place -= tensor.strides[d] * tensor.shape[d];
      at[d] = 0;
    }
  }
  return values;
}

std::optional<std::vector<double>> finite_values_of(const std::string& name,
                                                    const StoredTensor& tensor,
                                                    PolicyProblem& problem) {
  std::vector<double> values = values_of(tensor);
  if (!all_finite(values, name, "save", problem)) return std::nullopt;
  return values;
}

std::optional<std::vector<float>> floats_of(const std::string& name, const StoredTensor& tensor,
                                            PolicyProblem& problem) {
  if (!is_real(tensor.type)) {
    return refuse(problem, "E0615",
                  fmt::format("has weights that are integers in tensor `{}`", printable(name)),
                  "save the actor in float32");
  }
  const auto values = finite_values_of(name, tensor, problem);
  if (!values) return std::nullopt;
  return exact_floats(*values, name, "saving", problem);
}

bool TensorTable::add(const std::string& name, StoredTensor tensor, PolicyProblem& problem) {
  if (!fits(name, tensor, problem)) return false;
  if (tensors.size() >= kMaxTensors) {
    return refuse(problem, "E0619", fmt::format("has more than {} tensors", kMaxTensors),
                  "save the tensors of the actor alone");
  }
  if (tensors.emplace(name, std::move(tensor)).second) return true;
  return refuse(problem, "E0610", fmt::format("has two tensors `{}`", printable(name)),
                "give each tensor its own name");
}

}  // namespace eagerx::gen
