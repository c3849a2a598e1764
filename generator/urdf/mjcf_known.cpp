// Elements of MJCF, and those that do not change the motion.
#include <algorithm>
#include <iterator>

#include "generator/urdf/mjcf_document.hpp"

namespace eagerx::urdf {
namespace {

constexpr std::string_view kActuators[] = {"general",     "motor",  "position", "velocity",
                                           "intvelocity", "damper", "cylinder", "muscle",
                                           "adhesion",    "plugin", "dcmotor"};

bool check_parts_of_bodies(Xml& xml, pugi::xml_node e, std::string_view tag) {
  if (tag == "body" || tag == "worldbody" || tag == "frame") {
    xml.check(e, {.attributes = {"name", "childclass", "pos", "quat", "axisangle", "euler",
                                 "xyaxes", "zaxis", "mocap", "gravcomp", "user"},
                  .many = {"inertial", "joint", "freejoint", "geom", "body", "frame", "include",
                           "composite", "flexcomp", "replicate", "attach", "plugin"},
                  .ignored_attributes = {"sleep"},
                  .ignored = {"site", "camera", "light"}});
  } else if (tag == "inertial") {
    xml.check(e, {.attributes = {"class", "pos", "quat", "axisangle", "euler", "xyaxes", "zaxis",
                                 "mass", "diaginertia", "fullinertia"}});
  } else if (tag == "joint" && (e.attribute("joint1") || e.attribute("coef"))) {
    xml.check(e, {.attributes = {"name", "class", "joint1", "joint2", "polycoef", "active", "joint",
                                 "coef"},
                  .ignored_attributes = {"solref", "solimp"}});
  } else if (tag == "joint") {
    xml.check(e, {.attributes = {"name", "class", "type", "pos", "axis", "range", "limited",
                                 "stiffness", "springref", "damping", "armature", "frictionloss",
                                 "ref", "springdamper", "actuatorfrcrange", "actuatorfrclimited",
                                 "group", "user"},
                  .ignored_attributes = {"margin", "solreflimit", "solimplimit", "solreffriction",
                                         "solimpfriction", "actuatorgravcomp"}});
  } else if (tag == "freejoint") {
    xml.check(e, {.attributes = {"name", "class", "group", "align"}});
  } else if (tag == "geom") {
    xml.check(e, {.attributes = {"name",      "class", "type",    "pos",          "quat",
                                 "axisangle", "euler", "xyaxes",  "zaxis",        "fromto",
                                 "size",      "mass",  "density", "contype",      "conaffinity",
                                 "friction",  "mesh",  "hfield",  "shellinertia", "rgba",
                                 "material",  "group", "user"},
                  .many = {"plugin"},
                  .ignored_attributes = {"condim", "solref", "solimp", "margin", "gap", "priority",
                                         "solmix", "fitscale", "fluidshape", "fluidcoef"}});
  } else {
    return false;
  }
  return true;
}

bool check_actuator(Xml& xml, pugi::xml_node e) {
  if (!is_actuator(e.name())) return false;
  xml.check(
      e,
      {.attributes = {"name",        "class",       "joint",        "jointinparent", "tendon",
                      "site",        "refsite",     "body",         "slidersite",    "cranksite",
                      "cranklength", "ctrllimited", "forcelimited", "ctrlrange",     "forcerange",
                      "gear",        "kp",          "kv",           "dampratio",     "inheritrange",
                      "timeconst",   "dyntype",     "gaintype",     "biastype",      "dynprm",
                      "gainprm",     "biasprm",     "actlimited",   "actrange",      "user",
                      "group",       "plugin",      "instance",     "diameter",      "area",
                      "bias",        "gain",        "scale",        "force",         "range",
                      "lmin",        "lmax",        "vmax",         "fpmax",         "fvmax",
                      "tausmooth"},
       .many = {"config"},
       .ignored_attributes = {"lengthrange", "actdim", "actearly", "nsample", "interp", "delay"}});
  return true;
}

}  // namespace

bool is_actuator(std::string_view tag) {
  return std::ranges::find(kActuators, tag) != std::end(kActuators);
}

void check_known(Xml& xml, pugi::xml_node e) {
  const std::string_view tag = e.name();
  if (check_parts_of_bodies(xml, e, tag)) return;
  if (check_actuator(xml, e)) return;
  if (tag == "mesh") {
    xml.check(e, {.attributes = {"name", "class", "file", "content_type", "scale", "refpos",
                                 "refquat", "vertex", "face", "normal", "texcoord", "inertia",
                                 "smoothnormal", "maxhullvert", "material", "builtin", "params"},
                  .many = {"plugin"}});
  } else if (tag == "pair") {
    xml.check(e, {.attributes = {"name", "class", "geom1", "geom2"},
                  .ignored_attributes = {"condim", "friction", "solref", "solreffriction", "solimp",
                                         "gap", "margin"}});
  }
}

void check_sections(Xml& xml, pugi::xml_node root) {
  xml.check(root, {.attributes = {"model"},
                   .many = {"compiler", "option", "default", "asset", "worldbody", "contact",
                            "deformable", "equality", "tendon", "actuator", "keyframe", "include",
                            "extension"},
                   .ignored = {"size", "visual", "statistic", "custom", "sensor"}});
}

}  // namespace eagerx::urdf
