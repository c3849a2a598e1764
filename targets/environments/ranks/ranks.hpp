// The processes that share the work: one, or those that mpirun started.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace eagerx::environments {

/// Rank 0 has library, checkpoint and table, and prints. The others compute, and send it the
/// results. Call it from one thread at a time.
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

  /// Called by all ranks: `all` receives the bytes of each, in the order of ranks; all ranks know
  /// `sizes` [size()].
  virtual void gather(std::span<const char> mine, std::span<char> all,
                      std::span<const std::size_t> sizes) = 0;
  /// Called by all ranks: sends each rank its piece of `out`, `out_sizes` [size()]. `in` receives
  /// the pieces for this rank, in the order of their senders, `in_sizes` [size()].
  virtual void exchange(std::span<const char> out, std::span<const std::size_t> out_sizes,
                        std::span<char> in, std::span<const std::size_t> in_sizes) = 0;

  /// Called by all ranks: the bytes of each, in the order of ranks, of any length.
  std::vector<std::string> gather(const std::string& mine);
  /// Called by all: whether it is so in one of them.
  bool is_any(bool here);
};

/// The only one.
class Alone final : public Ranks {
 public:
  std::uint32_t rank() const override { return 0; }
  std::uint32_t size() const override { return 1; }
  std::string share(std::string bytes) override { return bytes; }
  void send(const std::string& /*bytes*/) override {}
  std::optional<std::string> take() override { return std::nullopt; }
  [[noreturn]] void abort(int exit_code) override;
  using Ranks::gather;
  void gather(std::span<const char> mine, std::span<char> all,
              std::span<const std::size_t> sizes) override;
  void exchange(std::span<const char> out, std::span<const std::size_t> out_sizes,
                std::span<char> in, std::span<const std::size_t> in_sizes) override;
};
/// For a program without other ranks.
Ranks& alone();

/// Of this program. One is alone, or it has the ranks of MPI: two libraries have this function.
/// Waiting for others that do not come throws client::Problem in rank 0 once a signal wants the end
/// (host::interrupted()): when one dies, mpirun tells the others so.
std::unique_ptr<Ranks> make_ranks(int& argc, char**& argv);

/// The parts first … end - 1 are those of one rank.
struct Share {
  std::size_t first, end;
};
/// Parts side by side, as many as other ranks have or one more.
Share share_of(std::size_t parts, std::uint32_t rank, std::uint32_t ranks);

/// A command line for other ranks, without the program's name, and its reconstruction there: a
/// command line of `name`, valid while `shared` lives.
std::string words_of(int argc, const char* const* argv);
std::vector<const char*> command_line(const char* name, const std::string& shared);

/// A private file with these bytes, for functions that open files. Throws client::Problem.
std::string file_of(const std::string& bytes);

}  // namespace eagerx::environments
