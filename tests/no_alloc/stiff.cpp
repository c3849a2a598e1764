// Ticks of OdeEngine with the method rodas4 under the guard, with Jacobians of dual numbers.
#include <cstdio>
#include <eagerx/rate.hpp>
#include <models/engines/ode_engine/ode_engine.hpp>

#include "tests/firmware/entities/robertson/robertson_ode.hpp"
#include "tests/firmware/entities/van_der_pol/van_der_pol_ode.hpp"

extern "C" {
void eagerx_run_begins();
void eagerx_run_ends();
}

namespace {

struct ModelIo {
  using Real = double;
};
struct EngineIo {
  using Real = double;
  using Rate = eagerx::Rate<1, 20>;
  struct States {};
  struct Config {
    static constexpr auto method = eagerx::models::OdeMethod::rodas4;
    static constexpr double rtol = 1e-6;
    static constexpr double atol = 1e-9;
    static constexpr double hmax = 0.0;
    static constexpr double hmin = 0.0;
    static constexpr int mxstep = 0;
  };
};

}  // namespace

int main() {
  eagerx::models::OdeSimulator<eagerx::tests::VanDerPolOde<ModelIo>> oscillator;
  eagerx::models::OdeSimulator<eagerx::tests::RobertsonOde<ModelIo>> reaction;
  eagerx::models::OdeEngine<EngineIo> engine;
  oscillator.reset();
  reaction.reset();
  oscillator.state = {{2.0, 0.0}};
  reaction.state = {{1.0, 0.0, 0.0}};
  eagerx_run_begins();
  for (eagerx::Seq n = 1; n <= 1000; ++n) engine.callback({n}, oscillator, reaction);
  eagerx_run_ends();
  const auto faults = oscillator.faults() + reaction.faults();
  std::printf("faults %u\n", static_cast<unsigned>(faults));
  std::fflush(stdout);  // before the guard's report
}
