// Sections of MJCF about a robot as a whole.
#pragma once

#include "generator/urdf/mjcf/frames.hpp"

namespace eagerx::urdf {

/// `option`; whether anything touches.
bool read_options(Document& document, Description& description);
/// `contact`: the pairs that can be simulated; of the others there is a warning.
void read_contacts(Document& document, Description& description);
/// `keyframe`: positions of hinges and slides.
void read_keyframes(Document& document, Description& description);
/// Whatever changes the motion and is not read.
void refuse_rest(Document& document, const Compiler& compiler);

}  // namespace eagerx::urdf
