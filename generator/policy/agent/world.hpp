// Compares the world that a policy was trained in, as far as its file describes it, with the graph.
#pragma once

#include "generator/policy/agent/use.hpp"

namespace eagerx::gen {

/// E0704: conversion of the outputs; E0705: bounds of actions; E0706: names and sizes of
/// observations; E0707: rate; E0708: shape of an image. Each error shows both sides. A warning if
/// names cannot be compared.
void check_policy_world(const PolicyUse& use, const Network& network, Diagnostics& diagnostics);

}  // namespace eagerx::gen
