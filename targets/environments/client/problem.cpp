#include "targets/environments/client/problem.hpp"

#include <fmt/format.h>

#include <cstdio>

namespace eagerx::client {

int tell(const std::exception& error) {
  fmt::print(stderr, "error: {}\n", error.what());
  const auto* const problem = dynamic_cast<const Problem*>(&error);
  if (problem == nullptr) return kProblems;
  if (!problem->help.empty()) fmt::print(stderr, "help: {}\n", problem->help);
  return problem->code;
}

}  // namespace eagerx::client
