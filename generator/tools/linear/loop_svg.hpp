// The loop opened at a port as a picture.
#pragma once

#include <string>

#include "generator/tools/linear/loop_curves.hpp"

namespace eagerx::gen {

/// Bode plot with the margins, Nyquist plot, poles of the closed loop, and step response, as SVG.
/// The same bytes on every machine. `title`: of the picture.
std::string loop_svg(const LoopCurves& curves, const std::string& title);

}  // namespace eagerx::gen
