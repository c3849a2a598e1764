#include "targets/environments/client/team.hpp"

#include <system_error>
#include <utility>

namespace eagerx::client {

Team::Team(unsigned threads) {
  helpers_.reserve(threads - 1);
  try {
    while (helpers_.size() + 1 < threads) helpers_.emplace_back([this] { serve(); });
  } catch (const std::system_error&) {
    // What is worked on does not depend on how many they are.
  }
}

Team::~Team() {
  leave_ = true;
  ++task_;
  task_.notify_all();
  for (std::thread& helper : helpers_) helper.join();
}

void Team::take_parts() {
  for (std::size_t part = next_++; part < parts_; part = next_++) {
    try {
      (*work_)(part);
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!failure_ || part < failed_) {
        failure_ = std::current_exception();
        failed_ = part;
      }
    }
  }
}

void Team::serve() {
  std::uint32_t seen = 0;
  while (true) {
    task_.wait(seen);
    seen = task_;
    if (leave_) return;
    take_parts();
    if (--busy_ == 0) busy_.notify_one();
  }
}

void Team::run(std::size_t parts, const std::function<void(std::size_t)>& work) {
  work_ = &work;
  parts_ = parts;
  next_ = 0;
  busy_ = static_cast<std::uint32_t>(helpers_.size());
  ++task_;
  task_.notify_all();
  take_parts();
  for (std::uint32_t left = busy_; left != 0; left = busy_) busy_.wait(left);
  if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
}

}  // namespace eagerx::client
