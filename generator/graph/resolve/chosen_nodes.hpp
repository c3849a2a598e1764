// Nodes as `placement:`, `--split` and `--of` call them.
#pragma once

#include <cstdint>
#include <string_view>

namespace eagerx::gen {

/// How a node matches a name: not at all; by its own name, or as an element of the array of this
/// name; or a part of such a composite.
enum class Called : std::uint8_t { no, itself, inside };

/// Whether `node` ("leg[2]/knee") is called by `name`: "leg[2]/knee", "leg[2]", "leg",
/// "leg[*]/knee". A `*` stands for any index.
Called is_called(std::string_view node, std::string_view name);

}  // namespace eagerx::gen
