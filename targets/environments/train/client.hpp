// The trainer's use of the client of libraries of environments.
#pragma once

#include <runtime/host/base/interrupt.hpp>
#include <runtime/host/base/thread_pool.hpp>

#include "targets/environments/client/description.hpp"
#include "targets/environments/client/files.hpp"
#include "targets/environments/client/library.hpp"
#include "targets/environments/client/problem.hpp"
#include "targets/environments/client/rows.hpp"
#include "targets/environments/client/words.hpp"

namespace eagerx::train {

using client::check_writable;
using client::claim_output;
using client::Description;
using client::Environments;
using client::ExitCode;
using client::Library;
using client::LibraryFunctions;
using client::minutes;
using client::print;
using client::Problem;
using client::read_description;
using client::read_file;
using client::rounded;
using client::Rows;
using client::Space;
using client::write_file;
using client::write_files;
using enum client::ExitCode;
using host::Interrupt;
using host::ThreadPool;

/// Whether a training is to end: the user has interrupted the program, or a parallel training has
/// failed.
class Stop {
 public:
  Stop(const Interrupt& interrupted)  // NOLINT(google-explicit-constructor): most have this one
      : Stop(interrupted, interrupted) {}
  Stop(const Interrupt& interrupted, const Interrupt& failed)
      : interrupted_(interrupted), failed_(failed) {}
  explicit operator bool() const { return interrupted_ || failed_; }

 private:
  const Interrupt& interrupted_;
  const Interrupt& failed_;
};

/// A step that can be learnt from. Throws Problem if a reward is not finite.
inline void step_all(Environments& environments, const float* action, Rows& rows) {
  if (environments.step(action, rows.pointers())) return;
  throw Problem(kProblems, environments.error(),
                "log() and sqrt() have no value below 0, a quotient none at 0: `max(x, 1e-6)` "
                "keeps x away from them. A simulation that breaks down needs `terminated:` before "
                "it does");
}

}  // namespace eagerx::train
