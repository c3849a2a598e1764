// Gym's pendulum is in the library. Write your own model here:
// models/engines/gym_engine/gym_model.hpp describes its interface.
#pragma once

#include <models/objects/gym_pendulum/gym_pendulum.hpp>
