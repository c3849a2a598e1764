// Reads the note in an image: whether the image belongs to the given graph, and its board.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "generator/driver/build/built.hpp"

namespace eagerx::gen {

/// The hash of the graph that targets/common/bare-metal/graph_note.hpp leaves in the file of an
/// image. Nothing if it leaves none, as a program with a main function of the user's own.
std::optional<std::uint64_t> graph_in_image(std::string_view file);

/// The id of the board that the same note names. Nothing if it names none.
std::optional<std::string> board_in_image(std::string_view file);

/// Before boards are started, as programs for Linux look themselves: E0519.
bool check_image_graphs(Run& run, const std::vector<BuiltProgram>& programs);

}  // namespace eagerx::gen
