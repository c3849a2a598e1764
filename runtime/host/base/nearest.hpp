// Finds the name that was probably meant.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace eagerx::host {

/// The name with the fewest letters left out, added, replaced or swapped, at most a third of them,
/// ignoring case; of several, the nearest one with case, then the first. Empty if none is near.
std::string nearest_name(std::string_view name, const std::vector<std::string>& known);

/// The name that is spelled with other separators: `robot.body.mass` and `robot/body/mass` are
/// `robot/body.mass`. Null if there is none, or more than one.
const std::string* spelled_otherwise(std::string_view name, const std::vector<std::string>& known);

/// All of them that have the parts of `name` in their order, where `/` and `.` separate parts:
/// `body/mass` and `robot.body` are in `robot/body.mass`.
std::vector<const std::string*> with_parts_of(std::string_view name,
                                              const std::vector<std::string>& known);

/// The one that `name` means: itself, spelled with other separators, or the only one with its
/// parts. Null if there is none, or more than one.
const std::string* name_meant(std::string_view name, const std::vector<std::string>& known);

/// One of the names of something; `of` is the one that is written. Names with no meaning of their
/// own, which are only to be near a mistyped one, are not `accepted`.
struct Named {
  std::string name, of;
  bool accepted = true;
};
/// The same for elements with several names: the `of` on which they agree. Null if there is none.
const std::string* name_meant(std::string_view name, const std::vector<Named>& known);
/// "did you mean `…`?" with the `of` of the nearest name; "it may be A, B" of several that have its
/// parts; or "available: A, B, C".
std::string suggestion(std::string_view name, const std::vector<Named>& known);

/// "did you mean `…`?" with it, or empty.
std::string did_you_mean(std::string_view name, const std::vector<std::string>& known);
/// The same, or "available: A, B, C"; empty if nothing is known.
std::string suggestion(std::string_view name, const std::vector<std::string>& known);

}  // namespace eagerx::host
