// The generated header of a policy.
#pragma once

#include <gtest/gtest.h>

#include <kainjow/mustache.hpp>
#include <string>

#include "generator/backend/emit/policy_view.hpp"
#include "generator/backend/emit/render.hpp"

namespace eagerx::gen {

inline std::string policy_header(const Network& network, PolicyTables& tables,
                                 const std::string& name, const std::string& in_namespace) {
  kainjow::mustache::data view = policy_view(network, tables);
  view.set("name", name);
  view.set("namespace", in_namespace);
  view.set("node", false);
  view.set("policy", "policy");
  view.set("derivatives", false);
  Diagnostics diagnostics;
  const auto text = render_file(EAGERX_SOURCE_DIR "/templates/cpp/policy.hpp.mustache",
                                "policy.hpp", view, diagnostics);
  for (const auto& problem : diagnostics.all()) ADD_FAILURE() << problem.message;
  return text.value_or("");
}

}  // namespace eagerx::gen
