// What the trainer uses of the programs around libraries of environments.
#pragma once

#include "targets/environments/client/description.hpp"
#include "targets/environments/client/files.hpp"
#include "targets/environments/client/library.hpp"
#include "targets/environments/client/problem.hpp"
#include "targets/environments/client/team.hpp"
#include "targets/environments/client/words.hpp"

namespace eagerx::train {

using client::check_writable;
using client::Description;
using client::Environments;
using client::ExitCode;
using client::Library;
using client::LibraryFunctions;
using client::minutes;
using client::Problem;
using client::read_description;
using client::read_file;
using client::rounded;
using client::Space;
using client::Team;
using client::write_file;
using enum client::ExitCode;

}  // namespace eagerx::train
