// The view of a message at the links to other programs.
#pragma once

#include <string>

#include "generator/backend/emit/names.hpp"

namespace eagerx::gen {

/// Into `view`: `link`, what `link_->get()` takes before the message, and a list `sends` of what
/// `link_->put()` takes for each part that gets it. `channel`: the constant of its channel, or
/// empty.
void add_links(const ProgramNames& names, const LinkUse& use, const std::string& channel,
               View& view);

}  // namespace eagerx::gen
