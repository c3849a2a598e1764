// Messages and turns of a part as tables, for languages that compile them into the program.
#pragma once

#include <map>
#include <string>

#include "generator/backend/emit/render.hpp"
#include "generator/backend/languages/layout.hpp"

namespace eagerx::gen {

/// Into `view`: messages, turns, actions, periods and their numbers. `names`: by node that runs.
void add_timetable(const Plan& plan, const PartLayout& layout,
                   const std::map<std::size_t, std::string>& names, View& view);

}  // namespace eagerx::gen
