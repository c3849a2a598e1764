#include "generator/driver/commands/policy_file.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <utility>
#include <vector>

#include "generator/policy/formats/golden.hpp"
#include "generator/policy/formats/read.hpp"
#include "generator/policy/network/limits.hpp"
#include "generator/policy/network/observations.hpp"

namespace eagerx::gen {
namespace {

/// "a,b" as a and b.
std::vector<std::string> parts_of(const std::string& text) {
  std::vector<std::string> parts;
  std::size_t first = 0;
  while (first < text.size()) {
    const std::size_t end = std::min(text.find(',', first), text.size());
    if (end > first) parts.push_back(text.substr(first, end - first));
    first = end + 1;
  }
  return parts;
}

}  // namespace

std::optional<Network> read_policy_file(const PolicyFile& file, Diagnostics& diagnostics,
                                        bool has_answers) {
  PolicyRequest request;
  request.path = request.name = file.file;
  request.normalize_path = request.normalize_name = file.normalize;
  request.context.output_name = file.output_name;
  request.context.actor = file.actor;
  request.context.state_dependent_std = file.state_dependent_std;
  request.context.has_answers = has_answers;
  request.context.layers = parts_of(file.layers);
  for (const std::string& size : parts_of(file.input_sizes)) {
    std::int64_t value = 0;
    const char* end = size.data() + size.size();
    const auto result = std::from_chars(size.data(), end, value);
    if (result.ec != std::errc{} || result.ptr != end || value < 1 || value > kMaxValues) {
      diagnostics.error("E0303", {}, fmt::format("`{}` is not a size of an input", size));
      return std::nullopt;
    }
    request.context.input_sizes.push_back(value);
  }
  for (const auto& [name, said] :
       {std::pair{&file.activation, &request.context.activation},
        std::pair{&file.output_activation, &request.context.output_activation}}) {
    if (name->empty()) continue;
    *said = activation_of(*name);
    if (*said) continue;
    diagnostics.error("E0303", {}, fmt::format("unknown activation `{}`", *name)).help =
        suggestion(*name, activation_names());
    return std::nullopt;
  }
  return read_policy(request, diagnostics);
}

std::optional<AskedRows> asked_rows(const Network& network, const AskedOptions& options,
                                    Diagnostics& diagnostics) {
  if (options.observations.empty()) {
    Sampling sampling;
    sampling.rows = options.rows.value_or(sampling.rows);
    sampling.seed = static_cast<std::uint32_t>(options.seed.value_or(sampling.seed));
    if (!check_work(network, sampling.rows, diagnostics)) return std::nullopt;
    return AskedRows{sampled_observations(network, sampling), describe(network, sampling)};
  }
  auto rows = read_golden(options.observations, options.observations, {}, diagnostics);
  if (!rows || !check_observations(network, *rows, options.observations, diagnostics) ||
      !check_work(network, rows->observations.size(), diagnostics)) {
    return std::nullopt;
  }
  std::string origin = fmt::format("{} of {}", rows->observations.size(), options.observations);
  return AskedRows{std::move(*rows), std::move(origin)};
}

}  // namespace eagerx::gen
