// Gym's pendulum is in the library. A model of your own would stand here: see
// models/engines/gym_engine/gym_model.hpp for what it has.
#pragma once

#include <models/objects/gym_pendulum/gym_pendulum.hpp>
