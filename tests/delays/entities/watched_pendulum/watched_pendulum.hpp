// The library's pendulum, on which a camera looks.
#pragma once

#include "models/objects/pendulum/pendulum_ode.hpp"
