// The library's arm, whose joints are set one by one.
#pragma once

#include <models/objects/two_link_arm/two_link_arm.hpp>
