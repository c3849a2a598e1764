// Observations to ask policies for their answers: sampled ones, or those of a file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "generator/policy/network/golden.hpp"
#include "generator/policy/network/network.hpp"
#include "generator/support/diagnostics/diagnostics.hpp"

namespace eagerx::gen {

/// Where sampled observations begin and how many there are.
struct Sampling {
  std::size_t rows = 1000;
  std::uint32_t seed = 1;
};

/// Rows of observations without answers. Each number is within two deviations of its mean if the
/// network has statistics, else within its bounds if the file says such, else in -1…1. Those of a
/// network with a memory are episodes of 32 rows. The same on every machine.
GoldenRows sampled_observations(const Network& network, const Sampling& sampling);

/// For people: "1000 sampled, seed 1, within 2 deviations of the statistics".
std::string describe(const Network& network, const Sampling& sampling);

/// Whether `network` can evaluate `rows` of the file `name`. E0632 if they do not have its size,
/// E0761 if it has memory and they do not mark the start of episodes.
bool check_observations(const Network& network, const GoldenRows& rows, const std::string& name,
                        Diagnostics& diagnostics);

/// Whether answering `rows` rows takes seconds to minutes, not days. E0760.
bool check_work(const Network& network, std::size_t rows, Diagnostics& diagnostics);

/// Puts the network's answers in float64 into `rows`, replacing previous ones: outputs,
/// actions where their bounds are known, normalised observations where it has statistics. E0759 if
/// an answer is not finite.
bool add_answers(const Network& network, GoldenRows& rows, Diagnostics& diagnostics);

}  // namespace eagerx::gen
