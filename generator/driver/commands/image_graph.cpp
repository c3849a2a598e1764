#include "generator/driver/commands/image_graph.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <runtime/host/base/hash.hpp>
#include <string>

#include "generator/support/quote/quote.hpp"

namespace eagerx::gen {

std::optional<std::uint64_t> graph_in_image(std::string_view file) {
  constexpr std::string_view kNote = "eagerx graph ";
  constexpr unsigned kByteBits = 8;
  const std::size_t at = file.find(kNote);
  if (at == std::string_view::npos || file.size() - at < kNote.size() + sizeof(std::uint64_t))
    return std::nullopt;
  std::uint64_t hash = 0;
  for (std::size_t i = sizeof hash; i-- > 0;)
    hash = hash << kByteBits | static_cast<unsigned char>(file[at + kNote.size() + i]);
  return hash;
}

std::optional<std::string> board_in_image(std::string_view file) {
  constexpr std::string_view kNote = "eagerx board ";
  constexpr std::size_t kLongest = 100;
  const std::size_t at = file.find(kNote);
  if (at == std::string_view::npos) return std::nullopt;
  const std::string_view rest = file.substr(at + kNote.size(), kLongest);
  const std::size_t end = rest.find('\0');
  return end == std::string_view::npos ? std::nullopt
                                       : std::optional<std::string>(rest.substr(0, end));
}

bool check_image_graphs(Run& run, const std::vector<BuiltProgram>& programs) {
  const std::size_t before = run.diagnostics.error_count();
  for (const BuiltProgram& program : programs) {
    if (!program.target->is_board() || !program.graph_hash) continue;
    std::ifstream in(program.image, std::ios::binary);
    const auto found = graph_in_image(std::string(std::istreambuf_iterator<char>(in), {}));
    if (!found || *found == *program.graph_hash) continue;
    run.diagnostics
        .error(
            "E0519", {},
            fmt::format("`{}` was built from another graph: its hash is {}, not {}", program.image,
                        host::hex_text(*found), host::hex_text(*program.graph_hash)))
        .help = fmt::format("delete the folder {}, and try again", shell_word(program.build));
  }
  return run.diagnostics.error_count() == before;
}

}  // namespace eagerx::gen
