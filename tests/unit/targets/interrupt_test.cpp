// targets/linux-sim/interrupt.hpp: which signals end a run, and how often.
#include "targets/linux-sim/interrupt.hpp"

#include <gtest/gtest.h>

#include <csignal>

namespace eagerx::linux_sim {
namespace {

// A closed terminal: from the shell first, from the kernel when the shell has ended. In between,
// the run has to bring its actuators to rest.
TEST(CatchInterrupts, OneThatComesTwiceLeavesTimeToStop) {
  for (const int signal : {SIGHUP, SIGTERM}) {
    catch_interrupts();
    for (int i = 0; i < 2; ++i) std::raise(signal);
    EXPECT_TRUE(interrupted());
    std::signal(signal, SIG_DFL);
  }
}

TEST(CatchInterrupts, ASecondCtrlCEndsTheProgram) {
  EXPECT_EXIT(
      {
        catch_interrupts();
        std::raise(SIGINT);
        std::raise(SIGINT);
      },
      ::testing::KilledBySignal(SIGINT), "");
}

TEST(CatchInterrupts, NohupStays) {
  std::signal(SIGHUP, SIG_IGN);
  catch_interrupts();
  EXPECT_EQ(std::signal(SIGHUP, SIG_DFL), SIG_IGN);
}

}  // namespace
}  // namespace eagerx::linux_sim
