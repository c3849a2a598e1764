// The results of a chunk as bytes: in a checkpoint, and between the ranks of a campaign.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "targets/environments/campaign/plan.hpp"
#include "targets/environments/campaign/results.hpp"

namespace eagerx::campaign {

struct Record {
  std::uint32_t chunk = 0;
  Results results;
};

/// Parses the JSON of a library's eagerx_counts().
Counts read_counts(const char* json);

/// Size, check sum, number of the chunk, runs, counts of faults as JSON; numbers as this machine
/// has them.
std::string record_of(std::uint32_t chunk, const Results& results);

/// Takes one from the front of `bytes`. Without a value if it is cut off, damaged or of no chunk of
/// `plan`.
std::optional<Record> take_record(std::string_view& bytes, const Plan& plan);

/// Where the next whole record of `bytes` begins, behind `from`: what follows a damaged one is
/// good. npos: there is none, or `work` is used up.
/// `work`: the number of bytes that may be summed up, from which each call takes its own. Bytes
/// that were
std::size_t find_record(std::string_view bytes, std::size_t from, const Plan& plan,
                        std::size_t& work);

}  // namespace eagerx::campaign
