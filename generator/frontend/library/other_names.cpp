#include "generator/frontend/library/other_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "generator/support/diagnostics/join.hpp"

namespace eagerx::gen {
namespace {

struct OtherName {
  std::string_view word, id;
};

constexpr std::array kOtherNames = {
    OtherName{"pd", "PidController"},
    OtherName{"pi", "PidController"},
    OtherName{"lqr", "StateFeedback"},
    OtherName{"lqg", "StateFeedback"},
    OtherName{"pole_placement", "StateFeedback"},
    OtherName{"luenberger", "Observer"},
    OtherName{"ekf", "ExtendedKalmanFilter"},
    OtherName{"kf", "KalmanFilter"},
    OtherName{"lowpass", "ButterworthFilter"},
    OtherName{"low_pass", "ButterworthFilter"},
    OtherName{"highpass", "ButterworthFilter"},
    OtherName{"notch", "DiscreteTransferFunction"},
    OtherName{"biquad", "DiscreteTransferFunction"},
    OtherName{"rate_limiter", "SlewLimit"},
    OtherName{"ramp", "Reference"},
    OtherName{"step", "Reference"},
    OtherName{"sine", "Reference"},
    OtherName{"chirp", "Reference"},
    OtherName{"noise", "SensorModel"},
    OtherName{"bias", "SensorModel"},
    OtherName{"deadband", "DeadZone"},
    OtherName{"clamp", "Saturation"},
    OtherName{"limit", "Saturation"},
    OtherName{"delay", "TransportDelay"},
};

std::string without_case(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

}  // namespace

std::vector<std::string> other_names(std::string_view word, const std::vector<std::string>& known) {
  constexpr std::size_t kShortest = 2, kMost = 8;
  const std::string wanted = without_case(word);
  std::vector<std::string> found;
  for (const OtherName& each : kOtherNames) {
    const bool exists = std::find(known.begin(), known.end(), each.id) != known.end();
    if (each.word == wanted && exists) found.emplace_back(each.id);
  }
  if (!found.empty() || wanted.size() < kShortest) return found;
  for (const std::string& name : known)
    if (without_case(name).find(wanted) != std::string::npos) found.push_back(name);
  if (found.size() > kMost) found.clear();
  return found;
}

std::string meant_by_other_name(std::string_view word, const std::vector<std::string>& known) {
  std::vector<std::string> quoted;
  for (const std::string& each : other_names(word, known))
    quoted.push_back(fmt::format("`{}`", each));
  return quoted.empty() ? std::string() : fmt::format("did you mean {}?", join(quoted, " or "));
}

}  // namespace eagerx::gen
