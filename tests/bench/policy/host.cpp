// Nanoseconds of one inference on this machine: ours, Eigen's fixed-size column-major product, and
// a plain loop over rows. Build with the flags that are measured (see ./host).
//   host                          all networks, all of them in turn
//   host NETWORK WHICH CALLS      one of them, for tools that count instructions
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string_view>

#include "eigen.hpp"
#include "networks.hpp"

namespace {

constexpr int kRounds = 40;
constexpr int kPlain = 4;
constexpr std::array<std::string_view, 5> kNames = {"exact", "fast", "int8", "eigen", "plain"};

template <class Network, int A, int B, bool Relu>
class Contest {
 public:
  /// Answers `calls` times with the one of that index in kNames; x changes with y, so that no call
  /// can be left out.
  void run(std::size_t which, int calls) const {
    float x[3] = {0.5F, -0.25F, 1.5F};
    float y[1] = {};
    const auto each = [&](auto&& answer) {
      for (int i = 0; i < calls; ++i) {
        answer();
        x[2] = 1.5F + y[0] * 0.125F;
      }
    };
    if (which == 0) each([&] { Network::run(*weights_, x, y); });
    if (which == 1) each([&] { Network::run_fast(*weights_, x, y); });
    if (which == 2) each([&] { Network::run_int8(*int8_, x, y); });
    if (which == 3) each([&] { eigen_->run(x, y); });
    if (which == 4) each([&] { Network::plain(*weights_, x, y); });
  }

  void print_times(const char* name, int calls) const {
    std::array<double, kNames.size()> best;
    best.fill(1e30);
    // In turn, so that all of them meet the same disturbances.
    for (int round = 0; round < kRounds; ++round) {
      for (std::size_t which = 0; which < kNames.size(); ++which) {
        best[which] = std::min(best[which], ns(which, which == kPlain ? calls / 8 : calls));
      }
    }
    std::printf("%s", name);
    for (std::size_t which = 0; which < kNames.size(); ++which) {
      std::printf(" %s %.0f", kNames[which].data(), best[which]);
    }
    std::printf("\n");
  }

 private:
  using Make = typename Network::Int8();

  /// ns a call.
  double ns(std::size_t which, int calls) const {
    const auto start = std::chrono::steady_clock::now();
    run(which, calls);
    const std::chrono::duration<double, std::nano> spent = std::chrono::steady_clock::now() - start;
    return spent.count() / calls;
  }
  static typename Network::Int8 int8_weights() {
    Make* volatile make = &Network::make_int8;  // g++ would take minutes to fold a call of it
    return make();
  }

  std::unique_ptr<typename Network::Weights> weights_ =
      std::make_unique<typename Network::Weights>(Network::make());
  std::unique_ptr<typename Network::Int8> int8_ =
      std::make_unique<typename Network::Int8>(int8_weights());
  std::unique_ptr<bench::EigenMlp<A, B, Relu>> eigen_ =
      std::make_unique<bench::EigenMlp<A, B, Relu>>();
};

}  // namespace

int main(int argc, char** argv) {
  const Contest<bench::Relu64, 64, 64, true> relu64;
  const Contest<bench::Tanh64, 64, 64, false> tanh64;
  const Contest<bench::Relu256, 256, 256, true> relu256;
  const Contest<bench::Relu400, 400, 300, true> relu400;
  if (argc == 1) {
    relu64.print_times("relu_64_64", 4000);
    tanh64.print_times("tanh_64_64", 4000);
    relu256.print_times("relu_256_256", 400);
    relu400.print_times("relu_400_300", 400);
    return 0;
  }
  if (argc != 4) return 2;
  const auto which = std::find(kNames.begin(), kNames.end(), std::string_view(argv[2]));
  if (which == kNames.end()) return 2;
  const auto index = static_cast<std::size_t>(which - kNames.begin());
  const std::string_view network = argv[1];
  const int calls = std::atoi(argv[3]);
  if (network == "relu_64_64") relu64.run(index, calls);
  if (network == "tanh_64_64") tanh64.run(index, calls);
  if (network == "relu_256_256") relu256.run(index, calls);
  if (network == "relu_400_300") relu400.run(index, calls);
}
