// Whatever an agent in another process sends to a program: datagrams, each with its length before
// it.
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <targets/linux-sim/external/external_agent.hpp>
#include <targets/linux-sim/options.hpp>
#include <tests/support/fake_program.hpp>

namespace {

using namespace eagerx::linux_sim;

void send_all(int socket, const std::uint8_t* data, std::size_t size) {
  while (size > 0) {
    const std::size_t length = std::min<std::size_t>(data[0], size - 1);
    send(socket, data + 1, length, MSG_DONTWAIT | MSG_NOSIGNAL);
    data += 1 + length;
    size -= 1 + length;
  }
  shutdown(socket, SHUT_WR);
}

/// A program's calls of an agent, as long as there is one.
void run(ExternalAgent& agent) {
  constexpr std::uint64_t kSteps = 3;
  if (!agent.open().empty()) std::abort();
  std::uint64_t step = 0;
  while (agent.go_on()) {
    if (agent.wants_reset()) {
      static_cast<void>(agent.key({}));
      agent.reset(0);
      step = 0;
    } else {
      agent.applied(agent.action());
      agent.step(++step, step == kSteps, false, {1.0, false, false, false});
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::array<int, 2> both{};
  if (socketpair(AF_UNIX, SOCK_SEQPACKET, 0, both.data()) != 0) std::abort();
  send_all(both[0], data, size);
  FakeProgram program;
  const Fields fields(program);
  Options options;
  options.real_time_factor = size % 2 == 0 ? 1.0 : 0.0;  // late, or waited for
  options.agent_socket = both[1];
  {
    ExternalAgent agent(options, fields, program, true);
    run(agent);
  }
  for (const int each : both) close(each);
  return 0;
}
