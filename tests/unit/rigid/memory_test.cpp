// Nothing allocates after the start, however many joints are moved, stopped and watched.
#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/unit/rigid/rigid_io.hpp"

namespace eagerx::models::testing {
namespace {

int allocations = 0;  // of the library

void* count_alloc(size_t size) {
  ++allocations;
  return std::malloc(size);
}
void* count_realloc(void* old, size_t, size_t size) {
  ++allocations;
  return std::realloc(old, size);
}

constexpr std::size_t kLinks = 24;
constexpr const char* kNames[kLinks] = {"a", "b", "c", "d", "e", "f", "g", "h", "i", "j", "k", "l",
                                        "m", "n", "o", "p", "q", "r", "s", "t", "u", "v", "w", "x"};

/// A chain along x, the first link free, with a ball in front of and behind the centre of each
/// link.
struct Snake {
  using Real = double;
  static constexpr auto kBodies = [] {
    std::array<RigidBody, kLinks> result{};
    for (std::size_t i = 0; i < kLinks; ++i)
      result[i] = {.name = kNames[i],
                   .mass = 0.1,
                   .inertia = {{1e-4, 1e-4, 1e-4}},
                   .position = {{0.1 * static_cast<double>(i), 0.0, 0.02}}};
    return result;
  }();
  static constexpr auto kJoints = [] {
    std::array<RigidJoint, kLinks - 1> result{};
    for (std::size_t i = 0; i + 1 < kLinks; ++i)
      result[i] = {.name = kNames[i],
                   .parent = kNames[i],
                   .child = kNames[i + 1],
                   .anchor = {{0.1 * (static_cast<double>(i) + 0.5), 0.0, 0.02}},
                   .axis = {{0.0, 0.0, 1.0}},
                   .low = -0.1,
                   .high = 0.1,
                   .stiffness = 0.01};
    return result;
  }();
  static constexpr auto kGeometries = [] {
    std::array<RigidGeometry, 2 * kLinks + 1> result{};
    for (std::size_t i = 0; i < 2 * kLinks; ++i)
      result[i] = {.name = kNames[i / 2],
                   .body = kNames[i / 2],
                   .size = {{0.02, 0.0, 0.0}},
                   .position = {{i % 2 == 0 ? -0.03 : 0.03, 0.0, 0.0}}};
    result[2 * kLinks] = {.name = "ground", .kind = ShapeKind::plane};
    return result;
  }();
};

struct StepConfig : RigidConfig<4> {
  static constexpr int max_contacts = 8;
};
struct QuickStepConfig : StepConfig {
  static constexpr auto method = OpenDynamicsMethod::quick_step;
};
struct ManyContacts : QuickStepConfig {
  static constexpr int max_contacts = 64;
};

template <class Config>
void expect_no_allocation() {
  dSetAllocHandler(count_alloc);
  dSetReallocHandler(count_realloc);
  Scene<Snake, Config> scene;
  EXPECT_GT(allocations, 0);
  allocations = 0;
  for (std::size_t g = 0; g < 2 * kLinks; ++g) scene.simulator.watch_contact_force(g);
  scene.reset();
  for (int i = 0; i < 20; ++i) {
    for (std::size_t j = 0; j + 1 < kLinks; ++j)
      scene.simulator.set_joint_motor(j, (static_cast<int>(j) + i) % 2 == 0 ? 5.0 : -5.0, 0.1);
    scene.tick();
  }
  dSetAllocHandler(nullptr);
  dSetReallocHandler(nullptr);
  EXPECT_EQ(allocations, 0);
}

TEST(Memory, StepGetsItAllAtTheStart) {
  expect_no_allocation<StepConfig>();
}
TEST(Memory, QuickStepGetsItAllAtTheStart) {
  expect_no_allocation<QuickStepConfig>();
}
TEST(Memory, ForManyContactsToo) {
  expect_no_allocation<ManyContacts>();
}

}  // namespace
}  // namespace eagerx::models::testing
