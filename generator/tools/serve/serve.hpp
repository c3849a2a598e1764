// The server of a graph's page that edits: eagerx-gen serve.
#pragma once

#include <string>

#include "generator/tools/serve/workshop.hpp"

namespace eagerx::gen::serve {

struct ServeOptions {
  std::string graph;  // a file, which need not be there yet
  int port = 0;       // 0: one that is free
};

/// Prints the address and serves it until SIGINT, SIGTERM or SIGHUP. Returns the exit code; what is
/// wrong is printed.
int serve(Workshop& workshop, const ServeOptions& options);

}  // namespace eagerx::gen::serve
