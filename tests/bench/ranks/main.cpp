// Measures the communication of ranks in a training: mpirun -n N ranks_bench WIDTH
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <functional>
#include <vector>

#include "targets/environments/train/ranks/gradient_sum.hpp"

namespace {

using namespace eagerx;

/// Of `work`, in µs: the median, and what one of ten is below.
struct Times {
  double median = 0.0, fast = 0.0;
};
Times measure(const std::function<void()>& work) {
  using Clock = std::chrono::steady_clock;
  constexpr std::size_t kTimes = 3000;
  std::vector<double> all;
  for (std::size_t i = 0; i < kTimes; ++i) {
    const auto begin = Clock::now();
    work();
    all.push_back(std::chrono::duration<double, std::micro>(Clock::now() - begin).count());
  }
  std::ranges::sort(all);
  return {all[kTimes / 2], all[kTimes / 10]};
}

}  // namespace

int main(int argc, char** argv) {
  const auto ranks = environments::make_ranks(argc, argv);
  const std::size_t width = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 64;
  train::Settings settings;
  settings.layers = {width, width};
  client::Description description;
  description.actions.push_back(
      {.name = "u", .dtype = "float32", .size = 1, .low = {-1}, .high = {1}});
  const train::Model model(settings, 3, train::Head(description));
  const auto share = environments::share_of(train::kParts, ranks->rank(), ranks->size());
  std::vector<train::Gradient> own(share.end - share.first, train::Gradient(model));
  std::vector<train::Gradient*> all;
  for (train::Gradient& one : own) all.push_back(&one);
  train::GradientSum sum(*ranks, model);
  const Times latency = measure([&] { ranks->is_any(false); });
  const Times update = measure([&] { sum.of(all); });
  if (!ranks->is_first()) return 0;
  const std::size_t numbers =
      model.actor.parameters() + model.critic.parameters() + model.log_deviation.size();
  fmt::print(
      "ranks {}, {} numbers: a byte of each to each {:.1f} us (fast: {:.1f}), a sum of "
      "gradients {:.1f} us (fast: {:.1f})\n",
      ranks->size(), numbers, latency.median, latency.fast, update.median, update.fast);
  return 0;
}
