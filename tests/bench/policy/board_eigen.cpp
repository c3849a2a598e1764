// Instructions of one inference with Eigen's fixed-size products on an emulated board, weights by
// column and by row.
#include "eigen.hpp"
#include "tests/bench/instructions.hpp"

namespace {

using eagerx::board::semihosting_write;

template <int A, int B, bool Relu, int Order>
void count() {
  static const bench::EigenMlp<A, B, Relu, Order> network;
  float x[3] = {0.5F, -0.25F, 1.5F};
  float y[1] = {};
  semihosting_write(" ");
  bench::print(bench::instructions([&] {
    network.run(x, y);
    x[2] = 1.5F + y[0] * 0.125F;
  }));
}

template <int A, int B, bool Relu>
void measure(const char* name) {
  semihosting_write(name);
  count<A, B, Relu, Eigen::ColMajor>();
  count<A, B, Relu, Eigen::RowMajor>();
  semihosting_write("\n");
}

}  // namespace

int main() {
  measure<64, 64, true>("relu_64_64");
  measure<64, 64, false>("tanh_64_64");
  measure<256, 256, true>("relu_256_256");
  measure<400, 300, true>("relu_400_300");
  eagerx::board::semihosting_exit(0);
}
