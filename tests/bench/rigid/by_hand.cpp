// The bare library: what a user of it would write for the same scenes.
#include <ode/ode.h>

#include <cmath>
#include <eagerx/math.hpp>

#include "loops.hpp"

namespace eagerx::bench {
namespace {

constexpr double kGravity = -9.81;

struct World {
  dWorldID id = dWorldCreate();
  World() { dWorldSetGravity(id, 0, 0, kGravity); }
  World(const World&) = delete;
  World& operator=(const World&) = delete;
  ~World() { dWorldDestroy(id); }
};

dBodyID make_body(const World& world, double mass, double x, double y, double z) {
  const dBodyID body = dBodyCreate(world.id);
  dMass all;
  dMassSetParameters(&all, mass, 0, 0, 0, x, y, z, 0, 0, 0);
  dBodySetMass(body, &all);
  return body;
}

// The pendulum's parameters, as MODELS of the library have them.
constexpr double kInertia = 0.000159931461600856, kMass = 0.0508581731919534;
constexpr double kLength = 0.0415233722862552, kDamping = 1.43298488358436e-05;
constexpr double kMotor = 0.0333391179016334, kResistance = 7.73125142447252;
constexpr double kFriction = 0.000975041213361349, kSlope = 165.417960777425;

}  // namespace

Seen pendulum_by_hand(std::uint64_t steps) {
  constexpr int kSubsteps = 30;
  constexpr double kStep = 1.0 / 30.0 / kSubsteps;
  const World world;
  constexpr double kOwn = kInertia - kMass * kLength * kLength;
  const dBodyID body = make_body(world, kMass, kOwn, kOwn, kOwn);
  dBodySetPosition(body, 0, 0, kLength);
  const dJointID hinge = dJointCreateHinge(world.id, nullptr);
  dJointAttach(hinge, body, nullptr);
  dJointSetHingeAnchor(hinge, 0, 0, 0);
  dJointSetHingeAxis(hinge, 0, 1, 0);
  const double theta = kTheta, omega = kThetaDot;
  const double s = std::sin(theta), c = std::cos(theta);
  const dQuaternion q = {std::cos(0.5 * theta), 0, std::sin(0.5 * theta), 0};
  dBodySetPosition(body, kLength * s, 0, kLength * c);
  dBodySetQuaternion(body, q);
  dBodySetLinearVel(body, omega * kLength * c, 0, -omega * kLength * s);
  dBodySetAngularVel(body, 0, omega, 0);
  double turns = 0.0, angle = theta, last = 0.0;
  for (std::uint64_t step = 0; step < steps; ++step) {
    const double voltage = voltage_at(step);
    for (int i = 0; i < kSubsteps; ++i) {
      const double speed = dJointGetHingeAngleRate(hinge);
      const double torque = kMotor / kResistance * (voltage - kMotor * speed) - kDamping * speed -
                            kFriction * eagerx::tanh(0.5 * kSlope * speed);
      dJointAddHingeTorque(hinge, torque);
      dWorldStep(world.id, kStep);
      const double now = dJointGetHingeAngle(hinge);  // within ±π: turns have to be counted
      if (step + static_cast<std::uint64_t>(i) > 0 && std::abs(now - last) > M_PI)
        turns += now < last ? 1.0 : -1.0;
      last = now;
    }
    angle = last + 2.0 * M_PI * turns;
  }
  return static_cast<float>(angle);
}

Seen box_by_hand(std::uint64_t steps) {
  constexpr int kSubsteps = 10;
  constexpr double kStep = 1.0 / 50.0 / kSubsteps;
  const World world;
  constexpr double kFlat = (0.04 + 0.01) / 12.0, kTall = 0.08 / 12.0;
  const dBodyID body = make_body(world, 1.0, kFlat, kFlat, kTall);
  dBodySetPosition(body, 0, 0, 0.05F);
  const dSpaceID space = dSimpleSpaceCreate(nullptr);
  const dGeomID plane = dCreatePlane(space, 0, 0, 1, 0);
  const dGeomID box = dCreateBox(space, 0.2, 0.2, 0.1);
  dGeomSetBody(box, body);
  const dJointGroupID contacts = dJointGroupCreate(0);
  for (std::uint64_t step = 0; step < steps; ++step) {
    for (int i = 0; i < kSubsteps; ++i) {
      dBodyAddForce(body, force_at(step), 0, 0);
      dContactGeom points[8];
      const int count = dCollide(box, plane, 8, points, sizeof(dContactGeom));
      for (int k = 0; k < count; ++k) {
        dContact contact{};
        contact.geom = points[k];
        contact.surface.mode = dContactApprox1 | dContactSoftERP | dContactSoftCFM | dContactFDir1;
        contact.surface.mu = 0.5;
        contact.surface.soft_erp = 0.2;
        contact.surface.soft_cfm = 1e-6;
        contact.fdir1[0] = 1.0;
        dJointAttach(dJointCreateContact(world.id, contacts, &contact), body, nullptr);
      }
      dWorldStep(world.id, kStep);
      dJointGroupEmpty(contacts);
    }
  }
  const double x = dBodyGetPosition(body)[0];
  dJointGroupDestroy(contacts);
  dSpaceDestroy(space);
  return static_cast<float>(x);
}

}  // namespace eagerx::bench
