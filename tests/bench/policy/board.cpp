// Instructions of one inference on an emulated board, after a comparison with plain loops.
#include <bit>
#include <cstdint>
#include <targets/common/bare-metal/semihosting.hpp>

#include "networks.hpp"
#include "tests/bench/instructions.hpp"
#include "tests/support/plain_sum.hpp"

namespace {

using bench::instructions;
using bench::print;
using eagerx::board::semihosting_write;

bool same(float a, float b) {
  return (a != a && b != b) || std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}

/// Layers and activations against plain loops over eagerx's functions: every bit.
template <eagerx::Activation A, std::size_t In, std::size_t Out>
bool check() {
  bench::Sampler sampler;
  static eagerx::DenseWeights<In, Out> layer;
  layer = bench::sampled<In, Out>(sampler);
  bool good = true;
  for (int round = 0; round < 50; ++round) {
    float x[In];
    float y[Out];
    for (float& value : x) value = sampler.next() * static_cast<float>(round);
    if (round == 1) x[In / 2] = __builtin_nanf("");
    if (round == 2) x[In / 2] = __builtin_inff();
    eagerx::dense<A>(layer, x, y, 0.5F);
    for (std::size_t out = 0; out < Out; ++out) {
      float row[In];
      for (std::size_t in = 0; in < In; ++in) row[in] = layer.w[layer.index(out, in)];
      const float sum = eagerx::test::plain_sum(row, x, In, layer.b[out], out, Out);
      good = good && same(y[out], eagerx::policy::activated<A>(sum, 0.5F));
    }
  }
  return good;
}

/// tanh and relu of every 4093rd float.
bool check_activations() {
  bool good = true;
  float y[8];
  float z[8];
  for (std::uint64_t word = 0; word <= 0xffffffffU - 8 * 4093; word += 8 * 4093) {
    for (std::uint32_t i = 0; i < 8; ++i) {
      y[i] = z[i] = std::bit_cast<float>(static_cast<std::uint32_t>(word) + i * 4093U);
    }
    eagerx::activate<eagerx::Activation::tanh>(y);
    for (std::uint32_t i = 0; i < 8; ++i) {
      const float x = z[i];
      good = good && same(y[i], eagerx::tanh(x));
      y[i] = x;
    }
    eagerx::activate<eagerx::Activation::relu>(y);
    for (std::uint32_t i = 0; i < 8; ++i) good = good && same(y[i], z[i] < 0.0F ? 0.0F : z[i]);
  }
  return good;
}

bool check_all() {
  using eagerx::Activation;
  const bool layers = check<Activation::relu, 3, 64>() && check<Activation::tanh, 17, 24>() &&
                      check<Activation::identity, 64, 1>() && check<Activation::elu, 9, 11>() &&
                      check<Activation::relu, 8, 8>() && check<Activation::gelu, 1, 1>() &&
                      check<Activation::tanh, 31, 13>() && check<Activation::identity, 11, 1>();
  return layers && check_activations();
}

template <class Network>
void measure(const char* name) {
  static constexpr typename Network::Weights kWeights = Network::make();
  static const float x[3] = {0.5F, -0.25F, 1.5F};
  float y[1] = {};
  semihosting_write(name);
  semihosting_write(" ");
  print(instructions([&] { Network::run(kWeights, x, y); }));
  semihosting_write(" ");
  print(instructions([&] {
    float z[1];
    Network::plain(kWeights, x, z);
  }));
  semihosting_write(" ");
  print(std::bit_cast<std::uint32_t>(y[0]));
  static constexpr typename Network::Int8 kInt8 = Network::make_int8();
  float eighth[1] = {};
  semihosting_write(" ");
  print(instructions([&] { Network::run_int8(kInt8, x, eighth); }));
  semihosting_write(" ");
  print(std::bit_cast<std::uint32_t>(eighth[0]));
  semihosting_write("\n");
}

/// A network with branches: its instructions, its products, the bits of its first answer.
void measure_branches() {
  using bench::Branches;
  static constexpr Branches::Weights kWeights = Branches::make();
  static float x[Branches::kHistory];
  bench::Sampler sampler;
  for (float& value : x) value = sampler.next();
  float y[Branches::kActions] = {};
  semihosting_write("branches_45_256_128_64_12 ");
  print(instructions([&] { Branches::run(kWeights, x, y); }));
  semihosting_write(" products ");
  print(static_cast<std::uint32_t>(Branches::kProducts));
  semihosting_write(" ");
  print(std::bit_cast<std::uint32_t>(y[0]));
  semihosting_write("\n");
}

}  // namespace

int main() {
  if (!check_all()) {
    semihosting_write("error: the layers have other bits than plain loops\n");
    eagerx::board::semihosting_exit(1);
  }
  measure<bench::Relu64>("relu_64_64");
  measure<bench::Tanh64>("tanh_64_64");
  measure<bench::Relu256>("relu_256_256");
  measure<bench::Relu400>("relu_400_300");
  measure_branches();
  eagerx::board::semihosting_exit(0);
}
