// The view of a message at the links to other programs.
#pragma once

#include <string>

#include "generator/backend/emit/names.hpp"

namespace eagerx::gen {

/// Sets in `view`: `link`, the first arguments of `link_->get()`, and a list `sends` of the
/// arguments of `link_->put()` for each part that receives the message. `channel`: the constant of
/// its channel, or empty.
void add_links(const ProgramNames& names, const LinkUse& use, const std::string& channel,
               View& view);

}  // namespace eagerx::gen
