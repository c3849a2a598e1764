// How fast the pendulum's drawing becomes pixels, in processor time: what `rgb_array` costs besides
// the step.
#include <cstdio>
#include <ctime>
#include <eagerx/picture.hpp>
#include <models/engine_nodes/pendulum_drawing/pendulum_drawing.hpp>
#include <utility>
#include <vector>

namespace {

struct Angle {
  float value = 0.0F;
  [[nodiscard]] bool empty() const { return false; }
  [[nodiscard]] float back() const { return value; }
};
struct Io {
  struct Simulator {};
  struct States {};
  struct Inputs {
    Angle angle;
  };
  struct Outputs {
    eagerx::Array<float, 24, 16> scene;
  };
  struct Config {
    static constexpr double length = 0.042;
    static constexpr bool weight = true, clockwise = true;
  };
};

/// Pictures a second of processor time; the bytes go into `sum` so that the compiler keeps them.
double pictures_a_second(int side, int count, unsigned& sum) {
  static eagerx::picture::Painter<480> painter;
  std::vector<std::uint8_t> pixels(static_cast<std::size_t>(3 * side * side));
  eagerx::models::PendulumDrawing<Io> drawing;
  Io::Simulator simulator;
  Io::Inputs in;
  Io::Outputs out{};
  const std::clock_t begin = std::clock();
  for (int i = 0; i < count; ++i) {
    in.angle.value = 0.01F * static_cast<float>(i);
    drawing.callback({}, in, out, simulator);
    painter.paint(out.scene.data, 24, {pixels.data(), side, side, 3});
    sum += pixels[static_cast<std::size_t>(3 * (i % (side * side)))];
  }
  return count / (static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
}

}  // namespace

int main() {
  unsigned sum = 0;
  for (const auto& [side, count] : {std::pair{64, 4000}, std::pair{480, 200}}) {
    double best = 0.0;
    for (int round = 0; round < 5; ++round) {
      const double rate = pictures_a_second(side, count, sum);
      best = rate > best ? rate : best;
    }
    std::printf("%dx%d: %.0f pictures a second of processor time\n", side, side, best);
  }
  return sum == 0 ? 1 : 0;
}
