// The processes that share a campaign: one, or those that mpirun has started.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace eagerx::campaign {

/// Rank 0 has library, checkpoint and table, and prints. The others compute, and send it what came
/// of it. One thread at a time.
class Ranks {
 public:
  Ranks() = default;
  virtual ~Ranks() = default;
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;

  virtual std::uint32_t rank() const = 0;
  virtual std::uint32_t size() const = 0;
  bool is_first() const { return rank() == 0; }

  /// Called by all: the bytes of rank 0.
  virtual std::string share(std::string bytes) = 0;
  /// To rank 0.
  virtual void send(const std::string& bytes) = 0;
  /// In rank 0: bytes that another has sent, in the order in which that one has sent them. Without
  /// a value if nothing has come.
  virtual std::optional<std::string> take() = 0;
  /// Ends all of them.
  [[noreturn]] virtual void abort(int exit_code) = 0;
};

/// Of this program. `eagerx-campaign` is alone; `eagerx-campaign-mpi` has the ranks of MPI.
std::unique_ptr<Ranks> make_ranks(int& argc, char**& argv);

}  // namespace eagerx::campaign
