// Robots in MuJoCo's XML.
#pragma once

#include <string>

#include "generator/urdf/urdf.hpp"
#include "generator/urdf/xml.hpp"

namespace eagerx::urdf {

/// Reads the part of MJCF that the engines can simulate
/// (https://mujoco.readthedocs.io/en/stable/XMLreference). An element that would change the motion
/// and cannot be simulated is an error; others are left out with a note. `root` is the element
/// `mujoco` of the file at `path`. Problems as those of read_file().
Description read_mjcf(const std::string& path, Xml& xml, pugi::xml_node root,
                      gen::SourceMap& sources, gen::Diagnostics& diagnostics);

}  // namespace eagerx::urdf
