// Any bytes as a robot's description in URDF or MJCF, as far as the object's files: no crash, no
// endless work, and either files or a reason.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "generator/urdf/robot.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace eagerx;  // NOLINT(google-build-using-namespace): a fuzzer, not a library
  gen::SourceMap sources;
  gen::Diagnostics diagnostics;
  const std::string text(reinterpret_cast<const char*>(data), size);
  const auto description = urdf::read_text("robot.xml", text, sources, diagnostics);
  const auto robot = description ? urdf::make_robot(*description, {}, diagnostics) : std::nullopt;
  if (robot.has_value() == diagnostics.has_errors()) std::abort();
  if (robot && (header_text(*robot).empty() || manifest_text(*robot).empty())) std::abort();
  static_cast<void>(render_text(diagnostics, sources, false));
  return 0;
}
