// The finished chunks of a campaign on the disk, so that a killed campaign can continue.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "targets/environments/campaign/plan.hpp"
#include "targets/environments/campaign/results.hpp"

namespace eagerx::campaign {

/// A line that identifies the campaign, then a record (record.hpp) for each chunk, in any order.
/// Records are only appended. A record cut off by a kill ends the file. A damaged record is
/// skipped.
class Journal {
 public:
  /// `identity`: a line; results of another one are none of ours. No file is touched yet.
  Journal(std::string path, std::string identity);
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  /// A new file. Throws Problem if it cannot be written, or if there is something in it.
  void begin();

  /// The contents read from a file.
  struct Found {
    std::vector<bool> done;         // of each chunk
    std::size_t damaged_bytes = 0;  // that were left out
    std::size_t first_damaged = 0;  // where they begin
    bool is_cut_off = false;        // they are the end of the file, as after a kill
  };
  /// Reads the existing records into `results`, and appends to the file. Rewrites a damaged file
  /// with its good records. Throws Problem if it is not a journal, or belongs to another campaign.
  Found resume(const Plan& plan, Results& results);
  /// By one thread at a time. Throws Problem if it cannot be written.
  void add(const std::string& record);

 private:
  void open(int flags);
  void write(const std::string& bytes) const;

  std::string path_, header_;
  int file_ = -1;
};

/// Throws Problem if a new journal would overwrite contents of this file: finished runs, or
/// anything else.
void refuse_full(const std::string& path);

/// Puts the results of a chunk in their place.
void put(const Plan& plan, std::uint32_t chunk, const Results& part, Results& all);

}  // namespace eagerx::campaign
