#include "generator/driver/commands/policy_file.hpp"

#include <fmt/core.h>

#include <utility>

#include "generator/policy/formats/golden.hpp"
#include "generator/policy/formats/read.hpp"
#include "generator/policy/network/observations.hpp"

namespace eagerx::gen {

std::optional<Network> read_policy_file(const PolicyFile& file, Diagnostics& diagnostics,
                                        bool has_answers) {
  PolicyRequest request;
  request.path = request.name = file.file;
  request.normalize_path = request.normalize_name = file.normalize;
  request.context.output_name = file.output_name;
  request.context.actor = file.actor;
  request.context.has_answers = has_answers;
  for (const auto& [name, said] :
       {std::pair{&file.activation, &request.context.activation},
        std::pair{&file.output_activation, &request.context.output_activation}}) {
    if (name->empty()) continue;
    *said = activation_of(*name);
    if (*said) continue;
    diagnostics.error("E0303", {}, fmt::format("unknown activation `{}`", *name));
    return std::nullopt;
  }
  return read_policy(request, diagnostics);
}

std::optional<AskedRows> asked_rows(const Network& network, const AskedOptions& options,
                                    Diagnostics& diagnostics) {
  if (options.observations.empty()) {
    Draw draw;
    draw.rows = options.rows.value_or(draw.rows);
    draw.seed = static_cast<std::uint32_t>(options.seed.value_or(draw.seed));
    if (!check_work(network, draw.rows, diagnostics)) return std::nullopt;
    return AskedRows{drawn_observations(network, draw), describe(network, draw)};
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
