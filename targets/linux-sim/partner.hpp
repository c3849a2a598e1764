// The main program of the board's half of a split graph, where the board runs Linux.
#pragma once

#include <csignal>
#include <cstdio>
#include <string_view>
#include <targets/common/partner.hpp>
#include <targets/linux-sim/link_port.hpp>
#include <targets/linux-sim/options.hpp>

namespace eagerx::linux_sim {

template <class Graph>
int serve(int argc, char** argv) {
  using Link = target::BoardLinkOf<Graph, LinkPort>;
  constexpr int kArguments = 3;
  const std::string_view option = argc == kArguments ? argv[1] : "";
  if (option != "--link" && option != "--listen") {
    std::fprintf(stderr,
                 "error: wrong usage\nhelp: %s --link TTY, or --listen unix:PATH, :PORT (for this "
                 "machine only) or HOST:PORT; serves the part of `%s` that the host's program was "
                 "split from\n",
                 argv[0], Graph::kName);
    return kBadUsage;
  }
  std::signal(SIGPIPE, SIG_IGN);  // a host that goes is no reason to be killed
  static Link link{};
  const bool open = option == "--link" ? link.port.open(argv[2], kDefaultBaud)
                                       : link.port.listen(argv[2], [](const std::string& text) {
                                           std::fputs((text + "\n").c_str(), stderr);
                                         });
  if (!open) {
    std::fprintf(stderr, "error: cannot open `%s`: %s\n", argv[2], link.port.error().c_str());
    return kBadFile;
  }
  target::serve<Graph, LinkPort>(target::program_of_run<target::BoardProgramOf<Graph, LinkPort>>,
                                 link, [] { return 0U; });
  return kDone;
}

}  // namespace eagerx::linux_sim
