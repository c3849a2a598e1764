#include "targets/environments/client/problem.hpp"

#include <fmt/format.h>

#include <cstdio>

namespace eagerx::client {

int tell(const std::exception& error, For whom) {
  const auto* const problem = dynamic_cast<const Problem*>(&error);
  if (whom == For::eagerx_gen && problem != nullptr && !problem->about.empty())
    fmt::print(stderr, "settings: {}\n", fmt::join(problem->about, " "));
  fmt::print(stderr, "error: {}\n", error.what());
  if (problem == nullptr) return kProblems;
  if (!problem->help.empty()) fmt::print(stderr, "help: {}\n", problem->help);
  return problem->code;
}

}  // namespace eagerx::client
