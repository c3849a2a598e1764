// Resets that wait for something which does not come: how they end.
#include <gtest/gtest.h>

#include "weak_reset/graph.hpp"

namespace {

/// Counts messages; interrupted from the one of that number on.
struct Interruption {
  static inline int messages = 0;
  static inline int at = 0;
  void on_episode(std::uint32_t /*index*/) { messages = 0; }
  template <class Message>
  void on_message(std::uint32_t /*channel*/, eagerx::Seq /*seq*/, const Message& /*message*/) {
    ++messages;
  }
  static bool is_interrupted() { return messages >= at; }
};

class ResetNode : public ::testing::Test {
 protected:
  using Graph = graphs::weak_reset::Graph;

  /// Messages of the second reset, which cannot reach its goal.
  int second_reset() {
    Interruption::at = INT32_MAX;
    program.hooks.on_episode(0);
    program.reset(Graph::sample({1, 0, 0}));
    Interruption::at = at;
    program.hooks.on_episode(1);
    program.reset(Graph::sample({1, 0, 1}));
    return Interruption::messages;
  }
  int at = INT32_MAX;
  Graph::Program<Interruption> program{};
};

TEST_F(ResetNode, GivesUpAfterItsTimeout) {
  EXPECT_GT(second_reset(), 2 * 30);
  EXPECT_EQ(program.reset_timeouts(), 1U);
}

TEST_F(ResetNode, GivesUpWhenTheRunIsToEnd) {
  at = 20;
  EXPECT_LT(second_reset(), 2 * 20);
  EXPECT_EQ(program.reset_timeouts(), 0U) << "its time was not over";
}

}  // namespace
