// The library's pendulum, on whose shaft two motors act.
#pragma once

#include <models/objects/pendulum/pendulum_ode.hpp>
