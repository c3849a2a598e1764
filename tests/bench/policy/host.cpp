// Nanoseconds of one inference on this machine: ours, Eigen's fixed-size column-major product, and
// a plain loop over rows. Build with the flags that are measured (see ./host).
#include <Eigen/Dense>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>

#include "networks.hpp"

namespace {

constexpr int kRounds = 25;

/// ns a call. `run(x, y)` answers for x; x changes with y, so that no call can be left out.
template <class Run>
double ns(int calls, Run&& run) {
  float x[3] = {0.5F, -0.25F, 1.5F};
  float y[1] = {};
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < calls; ++i) {
    run(x, y);
    x[2] = 1.5F + y[0] * 0.125F;
  }
  const std::chrono::duration<double, std::nano> spent = std::chrono::steady_clock::now() - start;
  return spent.count() / calls;
}

template <int A, int B, bool Relu>
struct EigenMlp {
  Eigen::Matrix<float, A, 3> w1 = Eigen::Matrix<float, A, 3>::Random() * 0.25F;
  Eigen::Matrix<float, B, A> w2 = Eigen::Matrix<float, B, A>::Random() * 0.25F;
  Eigen::Matrix<float, 1, B> w3 = Eigen::Matrix<float, 1, B>::Random() * 0.25F;
  Eigen::Matrix<float, A, 1> b1 = Eigen::Matrix<float, A, 1>::Random();
  Eigen::Matrix<float, B, 1> b2 = Eigen::Matrix<float, B, 1>::Random();

  template <class Vector>
  static Vector activated(const Vector& y) {
    if constexpr (Relu) return y.cwiseMax(0.0F);
    return y.array().tanh().matrix();
  }
  [[gnu::noinline]] void run(const float (&x)[3], float (&y)[1]) const {
    const Eigen::Map<const Eigen::Vector3f> in(x);
    Eigen::Matrix<float, A, 1> h1 = b1;
    h1.noalias() += w1 * in;
    h1 = activated(h1);
    Eigen::Matrix<float, B, 1> h2 = b2;
    h2.noalias() += w2 * h1;
    h2 = activated(h2);
    const Eigen::Array<float, 1, 1> out = (w3 * h2).array().tanh();
    y[0] = out(0);
  }
};

template <class Network, int A, int B, bool Relu>
void measure(const char* name, int calls) {
  auto weights = std::make_unique<typename Network::Weights>(Network::make());
  const auto eigen = std::make_unique<EigenMlp<A, B, Relu>>();
  auto* volatile make_int8 = &Network::make_int8;  // g++ would take minutes to fold a call of it
  const auto int8_weights = std::make_unique<typename Network::Int8>(make_int8());
  double ours = 1e30;
  double fast = 1e30;
  double int8 = 1e30;
  double theirs = 1e30;
  double plain = 1e30;
  // In turn, so that all of them meet the same disturbances.
  for (int round = 0; round < kRounds; ++round) {
    ours = std::min(ours, ns(calls, [&](auto& x, auto& y) { Network::run(*weights, x, y); }));
    fast = std::min(fast, ns(calls, [&](auto& x, auto& y) { Network::run_fast(*weights, x, y); }));
    int8 = std::min(int8,
                    ns(calls, [&](auto& x, auto& y) { Network::run_int8(*int8_weights, x, y); }));
    theirs = std::min(theirs, ns(calls, [&](auto& x, auto& y) { eigen->run(x, y); }));
    plain =
        std::min(plain, ns(calls / 8, [&](auto& x, auto& y) { Network::plain(*weights, x, y); }));
  }
  std::printf("%s exact %.0f fast %.0f int8 %.0f eigen %.0f plain %.0f\n", name, ours, fast, int8,
              theirs, plain);
}

}  // namespace

int main() {
  measure<bench::Relu64, 64, 64, true>("relu_64_64", 4000);
  measure<bench::Tanh64, 64, 64, false>("tanh_64_64", 4000);
  measure<bench::Relu256, 256, 256, true>("relu_256_256", 400);
  measure<bench::Relu400, 400, 300, true>("relu_400_300", 400);
}
