#include "generator/analysis/bound/missing.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "generator/analysis/bound/blame.hpp"
#include "generator/analysis/size/function_name.hpp"

namespace eagerx::gen::bound {
namespace {

struct Words {
  const char *what, *help;
};

Words words_of(Reason reason) {
  switch (reason) {
    case Reason::loop:
      return {"the loop",
              "let its turns have a limit that the compiler knows: count to a constant, or take "
              "`eagerx::bounded<N>(count)` of <eagerx/bounded.hpp>, which stops after N"};
    case Reason::several_entries:
      return {"the loop with several entries", "write it without `goto`, as one `for` or `while`"};
    case Reason::recursion:
      return {"the recursive call", "write it as a loop with a limit"};
    case Reason::pointer_call:
      return {"the call through a pointer",
              "call the function itself, or a template parameter: a pointer or a virtual function "
              "may lead anywhere"};
    case Reason::lost:
      break;
  }
  return {"the jump", "it leads to where this image has no code that can be followed"};
}

}  // namespace

NoBound no_bound(const Obstacle& obstacle, const std::set<Address>& roots, Analysis& analysis,
                 const Places& places, const std::vector<std::string>& names) {
  const Words words = words_of(obstacle.reason);
  NoBound missing{
      words.what, "", function_name(analysis.image().function_of(obstacle.at)), words.help, {}};
  const auto blamed = blamed_for(obstacle, roots, analysis, places);
  if (!blamed) return missing;
  const std::string file =
      std::filesystem::path(places.files()[blamed->place.file]).lexically_normal().string();
  missing.place = fmt::format("{}:{}", file, blamed->place.line);
  missing.function = names[blamed->place.function];
  if (blamed->of_library) {
    const bool is_std = places.functions()[*blamed->of_library].starts_with("_ZSt");
    missing.what =
        fmt::format("the call of `{}{}`", is_std ? "std::" : "", names[*blamed->of_library]);
    missing.help =
        "its loops are those of a library, without a limit that is known: write what you need of "
        "it as loops with limits; to sort a few elements, two counted loops do";
  }
  return missing;
}

}  // namespace eagerx::gen::bound
