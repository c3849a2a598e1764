// The main program of the board's half of a split graph, where the board runs Linux.
#pragma once

#include <csignal>
#include <cstdio>
#include <string>
#include <string_view>
#include <targets/common/partner.hpp>
#include <targets/linux-sim/keys.hpp>
#include <targets/linux-sim/link_port.hpp>
#include <targets/linux-sim/options.hpp>

namespace eagerx::linux_sim {

/// What the command line of a part says.
struct PartArguments {
  std::string_view option, line, key_file;
  bool is_good = false;
};

inline PartArguments read_part_arguments(int argc, char** argv) {
  PartArguments found;
  for (int i = 1; i + 1 < argc; i += 2) {
    const std::string_view name = argv[i];
    std::string_view& value = name == "--key" ? found.key_file : found.line;
    if (!value.empty() || (name != "--key" && name != "--link" && name != "--listen")) return {};
    if (name != "--key") found.option = name;
    value = argv[i + 1];
  }
  found.is_good = argc % 2 == 1 && !found.line.empty();
  return found;
}

template <class Graph>
int serve(int argc, char** argv) {
  using Link = target::BoardLinkOf<Graph, LinkPort>;
  const PartArguments arguments = read_part_arguments(argc, argv);
  if (!arguments.is_good) {
    std::fprintf(stderr,
                 "error: wrong usage\nhelp: %s --link TTY, or --listen unix:PATH, :PORT (for this "
                 "machine only) or HOST:PORT, which beyond this machine needs --key FILE; serves "
                 "the part of `%s` that the hub's program leaves out\n",
                 argv[0], Graph::kName);
    return kBadUsage;
  }
  std::signal(SIGPIPE, SIG_IGN);  // a host that goes is no reason to be killed
  static Link link{};
  const std::string line(arguments.line);
  if (!arguments.key_file.empty()) {
    const std::string problem = use_key_of(std::string(arguments.key_file), line, link.port);
    if (!problem.empty()) return std::fprintf(stderr, "%s\n", problem.c_str()), kBadFile;
  }
  const bool open = arguments.option == "--link"
                        ? link.port.open(line, kDefaultBaud)
                        : link.port.listen(line, [](const std::string& text) {
                            std::fputs((text + "\n").c_str(), stderr);
                          });
  if (!open) {
    std::fprintf(stderr, "error: cannot open `%s`: %s\n", line.c_str(), link.port.error().c_str());
    return kBadFile;
  }
  target::serve<Graph, LinkPort>(target::program_of_run<target::BoardProgramOf<Graph, LinkPort>>,
                                 link, [] { return 0U; });
  if (!link.port.is_forged()) return kDone;
  std::fprintf(stderr, "error: the line `%s` is closed: %s\n", line.c_str(),
               link.port.error().c_str());
  return kBadFile;
}

}  // namespace eagerx::linux_sim
