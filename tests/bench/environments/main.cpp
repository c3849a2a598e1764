// Environment steps a second of a graph's library, over those of its scalar program in a plain
// loop, with the same actions and episodes of 150 steps. One line for each batch: environments,
// threads, steps/s of processor time of a core (one thread) or of the wall clock (more), the same
// over the scalar program, bytes an environment.
#include <malloc.h>
#include <targets/environments/eagerx_environments.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <memory>
#include <targets/environments/layout.hpp>
#include <vector>
#include HEADER

namespace {

using Graph = NAMESPACE::Graph;
using Layout = eagerx::environments::Layout<Graph>;

constexpr std::uint32_t kLongest = 150;
constexpr std::size_t kRows = 64;  // of actions, in turn
constexpr int kRepeats = 5;

double cpu_ns() {
  std::timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * 1e9 + static_cast<double>(now.tv_nsec);
}
double wall_ns() {
  return static_cast<double>(std::chrono::steady_clock::now().time_since_epoch().count());
}

/// Rows of actions within their spaces.
std::vector<float> actions(std::size_t rows) {
  const std::size_t acted = Layout::get().actions.numbers();
  std::vector<float> result(rows * acted);
  for (std::size_t row = 0; row < rows; ++row) {
    auto action = Graph::random({1, 0, 0}, row % kRows);
    std::size_t field = 0;
    Graph::for_each_action(action, [&](const char*, const auto& message, const auto&) {
      const std::size_t first = Layout::get().actions.first(field++);
      for (std::size_t i = 0; i < eagerx::size_of<std::remove_cvref_t<decltype(message)>>; ++i)
        result[row * acted + first + i] = static_cast<float>(eagerx::element(message, i));
    });
  }
  return result;
}

/// Whether the task ends the episode.
template <class Program>
bool has_ended([[maybe_unused]] const Program& program) {
  if constexpr (requires { program.outcome(); }) {
    const auto outcome = program.outcome();
    return outcome.terminated || outcome.truncated;
  } else {
    return false;
  }
}

/// ns a step of the scalar program, with the resets that a batch has, too.
double alone(std::uint32_t steps, double (*now)()) {
  static NAMESPACE::Program<> program;
  std::array<Graph::Action, kRows> given;
  for (std::size_t i = 0; i < kRows; ++i) given[i] = Graph::random({1, 0, 0}, i);
  const double start = now();
  std::uint32_t age = 0, episode = 0;
  for (std::uint32_t step = 0; step < steps; ++step) {
    if (age == 0) program.reset(Graph::sample({1, 0, episode++}));
    program.step(given[step % kRows]);
    age = has_ended(program) || age + 1 == kLongest ? 0 : age + 1;
  }
  return (now() - start) / steps;
}

class Batch {
 public:
  Batch(std::uint32_t environments, std::uint32_t threads)
      : n_(environments),
        threads_(threads),
        action_((environments + kRows) * Layout::get().actions.numbers()) {
    action_ = actions(environments + kRows);
    observation_.resize(n_ * Layout::get().observations.numbers());
    reward_.resize(n_);
    ends_.resize(2 * std::size_t{n_});
    const std::size_t before = bytes_in_use();
    eagerx_options options{};
    options.size = sizeof(options);
    options.environments = n_;
    options.seed = 1;
    options.longest = kLongest;
    options.autoreset = EAGERX_SAME_STEP;
    options.threads = threads;
    environments_ = eagerx_create(&options);
    if (environments_ == nullptr ||
        eagerx_reset(environments_, nullptr, nullptr, observation_.data()) != 0) {
      std::fprintf(stderr, "%s\n", eagerx_error());
      std::exit(1);
    }
    bytes_ = bytes_in_use() - before;
  }
  Batch(const Batch&) = delete;
  Batch& operator=(const Batch&) = delete;
  ~Batch() { eagerx_destroy(environments_); }

  double bytes() const { return static_cast<double>(bytes_) / n_; }

  /// ns a step of an environment.
  double run(std::uint32_t steps, double (*now)()) {
    eagerx_rows rows{};
    rows.size = sizeof(rows);
    rows.observation = observation_.data();
    rows.reward = reward_.data();
    rows.terminated = ends_.data();
    rows.truncated = ends_.data() + n_;
    const double start = now();
    for (std::uint32_t step = 0; step < steps; ++step)
      eagerx_step(environments_, action_.data() + step % kRows * Layout::get().actions.numbers(),
                  &rows);
    return (now() - start) / (static_cast<double>(steps) * n_);
  }

 private:
  static std::size_t bytes_in_use() {
    const auto info = mallinfo2();
    return info.uordblks + info.hblkhd;
  }

  std::uint32_t n_, threads_;
  std::vector<float> action_, observation_, reward_;
  std::vector<std::uint8_t> ends_;
  eagerx_environments* environments_ = nullptr;
  std::size_t bytes_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
  const std::uint32_t total = argc > 1 ? static_cast<std::uint32_t>(std::atoi(argv[1])) : 400'000;
  alone(total / 4, cpu_ns);
  for (const std::uint32_t environments : {1U, 64U, 4096U}) {
    for (const std::uint32_t threads : {1U, 2U}) {
      if (environments == 1 && threads > 1) continue;
      Batch batch(environments, threads);
      const auto now = threads == 1 ? cpu_ns : wall_ns;
      double scalar = 1e30, best = 1e30;
      for (int i = 0; i < kRepeats; ++i) {  // in turn: what else the machine does hits both alike
        scalar = std::min(scalar, alone(total, now));
        best = std::min(best, batch.run(std::max(1U, total / environments), now));
      }
      std::printf("%s %u %u %.0f %.3f %.0f\n", Graph::kName, environments, threads, 1e9 / best,
                  scalar / best, batch.bytes());
    }
  }
  return 0;
}
