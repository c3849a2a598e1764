// Campaigns as pictures.
#pragma once

#include <string>
#include <vector>

#include "generator/tools/campaign/table.hpp"
#include "generator/tools/trace/trace.hpp"

namespace eagerx::gen::campaign {

/// How many runs have which return, and the share that succeeds over each column that differs.
std::string campaign_svg(const CampaignTable& table);

/// Two campaigns of the same runs, such as of two variants: the same pictures of both, and the
/// difference of the returns of each pair: run k of both began with the same samples.
std::string comparison_svg(const CampaignTable& first, const CampaignTable& second);

/// One or two tables of `eagerx-gen campaign --csv`, as SVG. A note if pairs have other samples.
TraceResult plot_campaigns(const std::vector<std::string>& paths);

}  // namespace eagerx::gen::campaign
