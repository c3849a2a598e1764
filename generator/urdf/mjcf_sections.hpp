// Sections of MJCF that apply to the whole robot.
#pragma once

#include "generator/urdf/mjcf_frames.hpp"

namespace eagerx::urdf {

/// Features that `flag` in `option` disables, except gravity.
struct Disabled {
  bool contact = false, limit = false, friction = false, equality = false, spring = false,
       damper = false;
};
/// `option`.
Disabled read_options(Document& document, Description& description);
/// Removes disabled features from the joints.
void disable(const Disabled& disabled, Description& description);
/// `contact`: the pairs that can be simulated; of the others there is a warning.
void read_contacts(Document& document, Description& description);
/// `keyframe`: positions of hinges and slides.
void read_keyframes(Document& document, Description& description);
/// Whatever changes the motion and is not read.
void refuse_rest(Document& document, const Compiler& compiler);

}  // namespace eagerx::urdf
