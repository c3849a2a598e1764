#include <runtime/host/trace/mcap.hpp>

#include "generator/tools/trace/convert.hpp"
#include "generator/tools/trace/timeline.hpp"

namespace eagerx::gen {

std::string trace_mcap(const trace_log::Log& log) {
  const Timeline timeline = timeline_of(log);
  trace_log::McapFile file(log.channels);
  for (std::size_t i = 0; i < log.rows.size(); ++i) {
    const auto& row = log.rows[i];
    file.add(row.channel, row.episode, row.seq, timeline.in_log_ns[i], log.values_of(row));
  }
  file.finish();
  return file.take();
}

}  // namespace eagerx::gen
