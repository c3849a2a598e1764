// After a fault of the processor: a timer would keep a motor at its last duty cycle for ever.
#include <targets/common/bare-metal/start.hpp>
#include <targets/stm32f405/pwm.hpp>

void eagerx_outputs_off() {
  eagerx::board::stm32::stop_all_pwm();
}
