// A world of the Open Dynamics Engine with its contacts.
#pragma once

#include <ode/ode.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <models/engines/open_dynamics_engine/heights.hpp>
#include <models/engines/open_dynamics_engine/library_faults.hpp>
#include <models/engines/open_dynamics_engine/rotation.hpp>
#include <mutex>

namespace eagerx::models {

enum class OpenDynamicsMethod : std::uint8_t { step, quick_step };

/// A geometry that touches others.
struct RigidShape {
  dGeomID geom = nullptr;
  dBodyID body = nullptr;  // null: part of the world
  double friction = 0.0;
  double bounce = 0.0;
  bool watched = false;                   // the force is observed
  const RigidHeights* heights = nullptr;  // instead of `geom`, a plane
  Vector3 force{};  // of all its contacts in the last step, in the world's axes [N]
};

/// The shapes of an object, in a list of objects.
struct RigidShapes {
  RigidShape* begin = nullptr;
  std::size_t count = 0;
  bool touch_each_other = false;
  RigidShapes* next = nullptr;
  // The object, and what names its fastest joint.
  const void* simulator = nullptr;
  const char* (*fastest)(const void* simulator, double& speed) = nullptr;
};

struct RigidWorldSettings {
  Vector3 gravity{};
  double erp = 0.0, cfm = 0.0;                  // of joints
  double contact_erp = 0.0, contact_cfm = 0.0;  // of contacts
  OpenDynamicsMethod method = OpenDynamicsMethod::step;
  int iterations = 0;  // quick_step
  double step_s = 0.0;
};

/// Bodies, joints and at most MaxContacts contacts. Pairs of shapes are checked in the order of
/// the objects and their geometries, so that a step depends on nothing but the state. All bytes are
/// zero until create(); nothing allocates after warm_up().
template <std::size_t MaxContacts>
class RigidWorld {
 public:
  constexpr RigidWorld() = default;
  RigidWorld(const RigidWorld&) = delete;
  RigidWorld& operator=(const RigidWorld&) = delete;
  /// constexpr, so that a program that has a world can be initialised when it is compiled (newer
  /// compilers insist).
  constexpr ~RigidWorld() {
    if (world_ == nullptr) return;
    dSpaceDestroy(space_);  // with its geometries
    dJointGroupDestroy(contacts_);
    dWorldDestroy(world_);  // with bodies and joints
    dThreadingFreeImplementation(threading_);
  }

  bool exists() const { return world_ != nullptr; }
  dWorldID id() const { return world_; }
  dSpaceID space() const { return space_; }
  /// Contacts that were left out because there were more than MaxContacts; saturates.
  std::uint32_t dropped_contacts() const { return dropped_; }

  void create(const RigidWorldSettings& settings) {
    use_library();
    settings_ = settings;
    world_ = dWorldCreate();
    // Its own: the one that worlds have otherwise is the process's, and a step in two threads
    // breaks it.
    threading_ = dThreadingAllocateSelfThreadedImplementation();
    dWorldSetStepThreadingImplementation(world_, dThreadingImplementationGetFunctions(threading_),
                                         threading_);
    space_ = dSimpleSpaceCreate(nullptr);
    contacts_ = dJointGroupCreate(0);
    const Vector3& g = settings.gravity;
    dWorldSetGravity(world_, g[0], g[1], g[2]);
    dWorldSetERP(world_, settings.erp);
    dWorldSetCFM(world_, settings.cfm);
    dWorldSetAutoDisableFlag(world_, 0);
    dWorldSetQuickStepNumIterations(world_, settings.iterations);
  }

  void add(RigidShapes& shapes) {
    RigidShapes** last = &first_;
    while (*last != nullptr) last = &(*last)->next;
    *last = &shapes;
  }

  /// Makes one step with the largest possible number of contacts, so that the library allocates all
  /// its memory here. Bodies and their forces have to be set afterwards.
  void warm_up() {
    std::size_t bodies = 0;
    for_each_body([&](dBodyID) { ++bodies; });
    for (std::size_t i = 0; bodies > 0 && i < MaxContacts; ++i) {
      dContact contact{};
      contact.surface.mode = dContactApprox1 | dContactSoftERP | dContactSoftCFM;
      contact.surface.mu = dInfinity;
      contact.surface.soft_erp = 1.0;
      contact.geom.depth = kWarmUpDepth;  // every contact pushes: nothing for the solver to decide
      contact.surface.soft_cfm = 1.0;     // as soft as to be harmless
      contact.geom.normal[2] = 1.0;
      const dBodyID body = body_at(i % bodies);  // once for each of its shapes
      const dBodyID other = body_at((i + 1) % bodies);
      const dJointID joint = attach(contact, body, other != body ? other : nullptr);
      dJointSetFeedback(joint, &feedback_[i]);  // quick_step needs memory for it
    }
    advance();
    forget_contacts();
    dropped_ = 0;
  }

  /// The generator of quick_step begins again.
  void begin_episode() {
    seed_ = 0;
    steps_ = 0;
    for_each_shape([](RigidShape& shape) { shape.force = {}; });
  }

  /// One step, with the forces that were added to the bodies.
  void step() {
    use_library();
    StepUnderWay::of_thread() = {first_, fastest_joint, ++steps_};
    for_each_shape([](RigidShape& shape) { shape.force = {}; });
    collide();
    advance();
    for (std::size_t i = 0; i < watched_; ++i) share_force(i);
    forget_contacts();
  }

 private:
  static constexpr int kPointsOfPair = 8;

  /// The library is set up once in a process, and stays; it has memory for each thread that calls
  /// it.
  static void use_library() {
    static const bool is_set_up = [] {
      tell_why_it_stops();
      return dInitODE2(0) != 0;
    }();
    struct OfThread {
      bool exists = is_set_up && dAllocateODEDataForThread(~0U) != 0;
      ~OfThread() {
        if (exists) dCleanupODEAllDataForThread();
      }
    };
    thread_local const OfThread memory;
    static_cast<void>(memory.exists);
  }

  static const char* fastest_joint(const void* objects, double& speed) {
    const char* name = "";
    speed = -1.0;
    for (auto object = static_cast<const RigidShapes*>(objects); object != nullptr;
         object = object->next) {
      double its = -1.0;
      const char* const joint = object->fastest(object->simulator, its);
      if (its <= speed) continue;  // what is not a number is the fastest
      speed = its;
      name = joint;
    }
    return name;
  }

  template <class F>
  void for_each_shape(F&& f) {
    for (RigidShapes* object = first_; object != nullptr; object = object->next) {
      for (std::size_t i = 0; i < object->count; ++i) f(object->begin[i]);
    }
  }
  template <class F>
  void for_each_body(F&& f) {
    for_each_shape([&](RigidShape& shape) {
      if (shape.body != nullptr) f(shape.body);
    });
  }
  dBodyID body_at(std::size_t position) {
    dBodyID result = nullptr;
    for_each_body([&](dBodyID body) {
      if (position-- == 0) result = body;
    });
    return result;
  }

  void collide() {
    for (RigidShapes* a = first_; a != nullptr; a = a->next) {
      for (std::size_t i = 0; i < a->count; ++i) {
        for (std::size_t k = i + 1; k < a->count; ++k) {
          RigidShape &one = a->begin[i], &other = a->begin[k];
          if (a->touch_each_other || one.body == nullptr || other.body == nullptr)
            touch(one, other);
        }
        for (RigidShapes* b = a->next; b != nullptr; b = b->next) {
          for (std::size_t k = 0; k < b->count; ++k) touch(a->begin[i], b->begin[k]);
        }
      }
    }
  }

  void touch(RigidShape& one, RigidShape& other) {
    if (one.body == other.body) return;
    if (one.body != nullptr && other.body != nullptr &&
        dAreConnectedExcluding(one.body, other.body, dJointTypeContact) != 0)
      return;
    if (one.heights != nullptr) return touch_ground(other, one);
    if (other.heights != nullptr) return touch_ground(one, other);
    dContactGeom points[kPointsOfPair];
    const int count = dCollide(one.geom, other.geom, kPointsOfPair, points, sizeof(dContactGeom));
    for (int i = 0; i < count; ++i) add_contact(points[i], one, other);
  }

  void touch_ground(RigidShape& shape, RigidShape& ground) {
    if (shape.body == nullptr) return;
    const GroundPoints points(shape.geom);
    for (std::size_t i = 0; i < points.count(); ++i) {
      const dContactGeom point = points.touch(i, *ground.heights);
      if (point.depth >= 0.0) add_contact(point, shape, ground);
    }
  }

  void add_contact(const dContactGeom& point, RigidShape& one, RigidShape& other) {
    if (count_ == MaxContacts) {
      if (dropped_ != std::numeric_limits<std::uint32_t>::max()) ++dropped_;
      return;
    }
    dContact contact{};
    contact.geom = point;
    contact.surface.mode = dContactApprox1 | dContactSoftERP | dContactSoftCFM;
    contact.surface.mu = one.friction * other.friction;
    contact.surface.soft_erp = settings_.contact_erp;
    contact.surface.soft_cfm = settings_.contact_cfm;
    const double bounce = eagerx::max(one.bounce, other.bounce);
    if (bounce > 0.0) {
      contact.surface.mode |= dContactBounce;
      contact.surface.bounce = bounce;
      contact.surface.bounce_vel = kSlowest;
    }
    align_friction(contact, one.body, other.body);
    const dJointID joint = attach(contact, one.body, other.body);
    if (one.watched || other.watched) {
      shapes_[watched_] = {&one, &other};
      dJointSetFeedback(joint, &feedback_[watched_++]);
    }
  }

  /// The library limits friction along two directions. With the first along the motion it is
  /// Coulomb's, whatever the direction.
  static void align_friction(dContact& contact, dBodyID one, dBodyID other) {
    const dReal* at = contact.geom.pos;
    dVector3 v1{}, v2{};
    if (one != nullptr) dBodyGetPointVel(one, at[0], at[1], at[2], v1);
    if (other != nullptr) dBodyGetPointVel(other, at[0], at[1], at[2], v2);
    const Vector3 n{{contact.geom.normal[0], contact.geom.normal[1], contact.geom.normal[2]}};
    const Vector3 v{{v1[0] - v2[0], v1[1] - v2[1], v1[2] - v2[2]}};
    const Vector3 sliding = v - dot(v, n) * n;
    const double square = dot(sliding, sliding);
    if (!(square > kSlowest * kSlowest)) return;
    const Vector3 direction = (1.0 / eagerx::sqrt(square)) * sliding;
    contact.surface.mode |= dContactFDir1;
    for (std::size_t i = 0; i < 3; ++i) contact.fdir1[i] = direction[i];
  }

  dJointID attach(const dContact& contact, dBodyID one, dBodyID other) {
    const dJointID joint = dJointCreateContact(world_, contacts_, &contact);
    dJointAttach(joint, one, other);
    ++count_;
    return joint;
  }

  void advance() {
    if (settings_.method == OpenDynamicsMethod::step) {
      dWorldStep(world_, settings_.step_s);
      return;
    }
    // The generator is the process's: worlds in several threads take turns, each with its own seed.
    static std::mutex generator;
    const std::lock_guard one_at_a_time(generator);
    dRandSetSeed(seed_);
    dWorldQuickStep(world_, settings_.step_s);
    seed_ = dRandGetSeed();
  }

  /// The library gives the force on the joint's first body; a joint with the world has one only.
  void share_force(std::size_t i) {
    const auto [one, other] = shapes_[i];
    const dReal* f = feedback_[i].f1;
    const Vector3 force{{f[0], f[1], f[2]}};
    const double sign = one->body != nullptr ? 1.0 : -1.0;
    one->force = one->force + sign * force;
    other->force = other->force - sign * force;
  }

  void forget_contacts() {
    dJointGroupEmpty(contacts_);
    count_ = 0;
    watched_ = 0;
  }

  static constexpr double kWarmUpDepth = 0.01;  // [m]
  static constexpr double kSlowest = 1e-6;      // [m/s] below, nothing slides or bounces

  struct Pair {
    RigidShape* one = nullptr;
    RigidShape* other = nullptr;
  };

  dWorldID world_ = nullptr;
  dThreadingImplementationID threading_ = nullptr;
  dSpaceID space_ = nullptr;
  dJointGroupID contacts_ = nullptr;
  RigidWorldSettings settings_{};
  RigidShapes* first_ = nullptr;
  std::size_t count_ = 0;
  std::size_t watched_ = 0;
  std::uint64_t steps_ = 0;  // of the episode
  std::array<Pair, MaxContacts> shapes_{};
  std::array<dJointFeedback, MaxContacts> feedback_{};
  unsigned long seed_ = 0;  // NOLINT(google-runtime-int): what dRandSetSeed takes
  std::uint32_t dropped_ = 0;
};

}  // namespace eagerx::models
