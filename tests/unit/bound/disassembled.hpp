// Images of which only the disassembly is given.
#pragma once

#include <optional>
#include <set>
#include <string>

#include "generator/analysis/bound/path.hpp"
#include "tests/unit/size/tools.hpp"

namespace eagerx::gen::bound {

/// The bytes of an ELF header without segments and sections.
inline std::string empty_elf() {
  std::string head = Tools::elf(Tools::kArm);
  head.resize(64, '\0');
  return head;
}

/// A disassembly with functions f at 0 and g at 0x100.
class Disassembled {
 public:
  explicit Disassembled(const std::string& f, const std::string& g = "",
                        const std::string& name_of_g = "g") {
    tools_.file("image.elf", empty_elf());
    tools_.says("objdump", "00000000 <f>:\n" + f + "\n00000100 <g>:\n" + g);
    tools_.says(
        "nm", std::string("00000001 T f\n") + (g.empty() ? "" : "00000101 T " + name_of_g + "\n"));
    image_ = Image::read(tools_.image(), "arm-none-eabi-");
  }

  [[nodiscard]] const std::optional<Image>& image() const { return image_; }

  struct Result {
    std::uint64_t most = 0;
    std::set<Reason> why;
    bool operator==(const Result&) const = default;
  };
  Result bound() {
    if (!image_) return {0, {Reason::lost}};
    Analysis analysis(*image_);
    LongestPath path(Weight::all());
    Result result{path.of(analysis.of(0)), {}};
    for (const Obstacle& obstacle : path.obstacles()) result.why.insert(obstacle.reason);
    return result;
  }

 private:
  Tools tools_;
  std::optional<Image> image_;
};

}  // namespace eagerx::gen::bound
