// The main program of the board's half of a split graph, where the board runs Linux.
#pragma once

#include <csignal>
#include <cstdint>
#include <cstdio>
#include <new>
#include <runtime/host/base/number.hpp>
#include <string>
#include <string_view>
#include <targets/common/partner.hpp>
#include <targets/linux-sim/keys.hpp>
#include <targets/linux-sim/link_port.hpp>
#include <targets/linux-sim/options.hpp>

namespace eagerx::linux_sim {

/// The command line of a part.
struct PartArguments {
  std::string_view option, line, key_file;
  double reconnect_s = 0.0;  // how long a hub that is lost is waited for; 0: not
  bool is_good = false;
};

inline PartArguments read_part_arguments(int argc, char** argv) {
  PartArguments found;
  for (int i = 1; i + 1 < argc; i += 2) {
    const std::string_view name = argv[i];
    if (name == "--reconnect") {
      if (!host::read_number(argv[i + 1], kLeastReconnectS, kMostReconnectS, found.reconnect_s))
        return {};
      continue;
    }
    std::string_view& value = name == "--key" ? found.key_file : found.line;
    if (!value.empty() || (name != "--key" && name != "--link" && name != "--listen")) return {};
    if (name != "--key") found.option = name;
    value = argv[i + 1];
  }
  found.is_good = argc % 2 == 1 && !found.line.empty();
  return found;
}

/// Reopens the line. False: reports the reason.
inline bool open_line(LinkPort& port, const PartArguments& arguments, bool is_again) {
  const std::string line(arguments.line);
  if (!arguments.key_file.empty()) {
    const std::string problem = use_key_of(std::string(arguments.key_file), line, port);
    if (!problem.empty()) return std::fprintf(stderr, "%s\n", problem.c_str()), false;
  }
  constexpr double kNsPerSecond = 1e9;
  if (arguments.reconnect_s > 0.0)
    port.notice_cuts(is_again ? static_cast<std::uint64_t>(arguments.reconnect_s * kNsPerSecond)
                              : UINT64_MAX);
  const bool is_open = arguments.option == "--link"
                           ? port.open(line, kDefaultBaud)
                           : port.listen(line, [](const std::string& text) {
                               std::fputs((text + "\n").c_str(), stderr);
                             });
  if (!is_open)
    std::fprintf(stderr,
                 is_again ? "error: the hub has not come back to `%s`: %s\n"
                          : "error: cannot open `%s`: %s\n",
                 line.c_str(), port.error().c_str());
  return is_open;
}

template <class Graph>
int serve(int argc, char** argv) {
  using Link = target::BoardLinkOf<Graph, LinkPort>;
  const PartArguments arguments = read_part_arguments(argc, argv);
  if (!arguments.is_good) {
    std::fprintf(stderr,
                 "error: wrong usage\nhelp: %s --link TTY, or --listen unix:PATH, :PORT (for this "
                 "machine only) or HOST:PORT, which beyond this machine needs --key FILE; with "
                 "--reconnect S it waits S seconds for a hub that it has lost; serves the "
                 "part of `%s` that the hub's program leaves out\n",
                 argv[0], Graph::kName);
    return kBadUsage;
  }
  std::signal(SIGPIPE, SIG_IGN);  // a host that goes is no reason to be killed
  constinit static target::BoardProgramOf<Graph, LinkPort> program{};
  static Link link{};
  for (bool is_again = false;; is_again = true) {
    if (!open_line(link.port, arguments, is_again)) return kBadFile;
    const bool has_finished = target::serve<Graph, LinkPort>(program, link, [] { return 0U; });
    const bool is_forged = link.port.is_forged();
    if (has_finished || (arguments.reconnect_s <= 0.0 && !is_forged)) return kDone;
    std::fprintf(stderr, "%s: the line `%.*s` is closed: %s\n",
                 arguments.reconnect_s > 0.0 ? "note" : "error",
                 static_cast<int>(arguments.line.size()), arguments.line.data(),
                 link.port.error().c_str());
    if (arguments.reconnect_s <= 0.0) return kBadFile;
    link.~Link();
    ::new (static_cast<void*>(&link)) Link{};
  }
}

}  // namespace eagerx::linux_sim
