// 168 MHz from the internal oscillator, because boards have different crystals or none. Its
// accuracy is 1 % (DS8626, table 41). Not tried on hardware; QEMU has no clock tree.
#include <targets/common/bare-metal/start.hpp>
#include <targets/stm32f405/registers.hpp>

static_assert(EAGERX_CLOCK_HZ == 168'000'000, "the dividers below make 168 MHz");

void eagerx_board_start() {
  using namespace eagerx::board;
  using namespace eagerx::board::stm32;
  using Memory = MappedMemory;
  constexpr std::uint32_t kInternalReady = 1U << 1U;
  // Set after every reset of the hardware; QEMU reads 0 and runs at 168 MHz as it is.
  if (!has_bits<Memory>(rcc::kControl, kInternalReady)) return;

  constexpr std::uint32_t kFiveWaitStates = 5;  // 3.5.1: 168 MHz at 2.7 to 3.6 V
  constexpr std::uint32_t kPrefetchAndCaches = 7U << 8U;
  Memory::write(flash::kAccessControl, kPrefetchAndCaches | kFiveWaitStates);

  // 16 MHz / 16 * 336 / 2; the last one, for USB, must divide to 48 MHz or less.
  constexpr std::uint32_t kM = 16U;
  constexpr std::uint32_t kN = 336U << 6U;
  constexpr std::uint32_t kPBy2 = 0U << 16U;
  constexpr std::uint32_t kQ = 7U << 24U;
  Memory::write(rcc::kPll, kM | kN | kPBy2 | kQ);
  constexpr std::uint32_t kPllOn = 1U << 24U;
  constexpr std::uint32_t kPllReady = 1U << 25U;
  set_bits<Memory>(rcc::kControl, kPllOn);
  while (!has_bits<Memory>(rcc::kControl, kPllReady)) {
  }

  constexpr std::uint32_t kApb1By4 = 5U << 10U;  // 42 MHz at most
  constexpr std::uint32_t kApb2By2 = 4U << 13U;  // 84 MHz at most
  constexpr std::uint32_t kFromPll = 2U;
  constexpr std::uint32_t kIsFromPll = 2U << 2U;
  Memory::write(rcc::kConfiguration, kApb1By4 | kApb2By2 | kFromPll);
  while (!has_bits<Memory>(rcc::kConfiguration, kIsFromPll)) {
  }
}
