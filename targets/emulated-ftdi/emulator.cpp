#include <fcntl.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <targets/emulated-ftdi/emulator.hpp>

namespace eagerx::emulated {
namespace {

// libusb's error codes.
constexpr int kNoDevice = -4;
constexpr int kTimeout = -7;

// Overhead of a bulk transfer: a microframe of high-speed USB and the host's work.
constexpr std::int64_t kTransferNs = 125 * kNsPerUs;
constexpr std::int64_t kByteNs = 25;  // 40 MB/s

std::uint32_t kinds_of(const std::string& names) {
  std::uint32_t kinds = 0;
  std::istringstream text(names);
  for (std::string name; std::getline(text, name, ',');) {
    for (std::size_t i = 0; i < kFaults; ++i) {
      if (name == kFaultNames[i]) kinds |= 1U << i;
    }
  }
  return kinds;
}

const Model* model_of(const std::string& name) {
  for (const Model* const model : {&kFt232h, &kFt2232h, &kFt4232h}) {
    if (name == model->name) return model;
  }
  return nullptr;
}

Settings settings_from_environment() {
  Settings settings;
  const char* const text = std::getenv("EAGERX_EMULATOR");
  std::istringstream words(text == nullptr ? "" : text);
  for (std::string word; words >> word;) {
    const std::size_t equals = word.find('=');
    const std::string name = word.substr(0, equals);
    const std::string value = equals == std::string::npos ? "" : word.substr(equals + 1);
    if (name == "time") {
      settings.emulated_time = value != "real";
    } else if (name == "seed") {
      settings.seed = std::strtoull(value.c_str(), nullptr, 10);
    } else if (name == "faults") {
      settings.faults = std::strtod(value.c_str(), nullptr);
    } else if (name == "kinds") {
      settings.kinds = kinds_of(value);
    } else if (name == "most") {
      settings.most = std::strtoull(value.c_str(), nullptr, 10);
    } else if (name == "from") {
      settings.from_s = std::strtod(value.c_str(), nullptr);
    } else if (name == "absent") {
      settings.absent_s = std::strtod(value.c_str(), nullptr);
    } else if (name == "pendulum") {
      settings.pendulum = value;
    } else if (name == "motor_delay") {
      settings.motor_delay_s = std::strtod(value.c_str(), nullptr);
    } else if (name == "report") {
      settings.report = value;
    } else if (name == "voltages") {
      settings.voltages = value;
    } else if (name == "chip" && model_of(value) != nullptr) {
      settings.model = *model_of(value);
    } else if (name == "wired" && value.size() == 1 && value[0] >= 'A' && value[0] <= 'D') {
      settings.wired = static_cast<unsigned>(value[0] - 'A');
    } else {
      std::fprintf(stderr, "emulated-ftdi: EAGERX_EMULATOR has no `%s`\n", name.c_str());
      std::exit(2);
    }
  }
  return settings;
}

}  // namespace

Emulator& emulator() {
  // Never destroyed: whatever runs last may still look at the clock.
  static Emulator* const instance = [] {
    std::atexit([] { emulator().report(); });
    return new Emulator(settings_from_environment());
  }();
  return *instance;
}

Emulator::Emulator(Settings settings)
    : settings_(std::move(settings)),
      time_(settings_.emulated_time),
      encoder_(pendulum_),
      converter_(pendulum_) {
  if (!pendulum_.scale(settings_.pendulum)) {
    std::fprintf(stderr, "emulated-ftdi: no factors of the pendulum: `%s`\n",
                 settings_.pendulum.c_str());
    std::exit(2);
  }
  pendulum_.delay_motor(static_cast<std::int64_t>(settings_.motor_delay_s * double{kNsPerSecond}));
  faults_.configure(settings_.seed, settings_.faults, settings_.kinds, settings_.most);
  faults_from_ns_ =
      time_.now_ns() + static_cast<std::int64_t>(settings_.from_s * double{kNsPerSecond});
  if (settings_.absent_s > 0.0) {
    pull_out(static_cast<std::int64_t>(settings_.absent_s * double{kNsPerSecond}));
  }
  if (!settings_.voltages.empty()) {
    constexpr int kReadWriteForAll = 0666;
    voltages_ = ::open(settings_.voltages.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC,
                       kReadWriteForAll);
  }
  set_model(settings_.model, settings_.wired);
  chip_.wire(0, encoder_);
  chip_.wire(1, converter_);
  chip_.wire(imu_);
  chip_.wire(pwm_);
  chip_.wire(servo_);
}

void Emulator::set_model(const Model& model, unsigned wired) {
  settings_.model = model;
  settings_.wired = wired;
  chip_.set_open_drain(model.release == kFt232h.release);
  chip_.reset();
}

void Emulator::report() const {
  if (settings_.report.empty()) return;
  std::FILE* const file = std::fopen(settings_.report.c_str(), "w");
  if (file == nullptr) return;
  const auto line = [&](const char* name, std::uint64_t count) {
    std::fprintf(file, "%s %llu\n", name, static_cast<unsigned long long>(count));
  };
  line("out", usb_.out);
  line("in", usb_.in);
  line("empty", usb_.empty);
  line("batches", usb_.batches);
  line("elsewhere", usb_.elsewhere);
  line("samples", encoder_.samples());
  line("writes", converter_.writes());
  line("wrong_modes", chip_.wrong_modes());
  for (std::size_t i = 0; i < kFaults; ++i) line(kFaultNames[i], faults_.count(Fault(i)));
  line("unsafe_starts", converter_.unsafe_starts());
  line("slowest_zero_us",
       static_cast<std::uint64_t>(converter_.slowest_zero_ns(time_.now_ns()) / kNsPerUs));
  std::fprintf(file, "voltage %.6f\ntheta %.6f\nomega %.6f\n", pendulum_.voltage(),
               pendulum_.theta(), pendulum_.omega());
  std::fclose(file);
}

/// At once, for a program that is killed leaves no report.
void Emulator::note_voltage(std::int64_t begun_ns) const {
  if (voltages_ >= 0)
    dprintf(voltages_, "%lld %lld %.6f\n", static_cast<long long>(begun_ns),
            static_cast<long long>(time_.now_ns()), pendulum_.voltage());
}

bool Emulator::is_there() {
  if (!there_ && time_.now_ns() >= back_ns_) {
    there_ = true;
    ++plugged_;
  }
  return there_;
}

void Emulator::pull_out(std::int64_t for_ns) {
  pendulum_.advance(time_.now_ns());
  there_ = false;
  back_ns_ = time_.now_ns() + for_ns;
  to_host_.clear();
  stale_.clear();
  pull_out_next_ = false;
  first_part_ = 0;
  answer_ns_ = 0;
  chip_.reset();
}

std::uint64_t Emulator::open() {
  constexpr std::int64_t kOpening = 2 * kNsPerMs;
  time_.pass(kOpening);
  return plugged_;
}

std::int64_t Emulator::oversleep_ns() {
  if (!has_faults()) return 0;
  return faults_.oversleep_ns();
}

int Emulator::control(std::uint64_t opened, unsigned interface, std::uint8_t type,
                      std::uint8_t request, std::uint16_t value, std::uint8_t* data,
                      std::uint16_t n) {
  time_.pass(kTransferNs);
  if (gone(opened)) return kNoDevice;
  if (type == 0x40 && interface != settings_.wired) return n;
  if (type == 0x40) {
    if (request == 0x00) {  // reset; 1 and 2 purge
      to_host_.clear();
      chip_.purge();
    } else if (request == 0x09) {
      latency_ms_ = static_cast<std::uint8_t>(value);
    } else if (request == 0x0b) {
      const bool has_mpsse = interface < settings_.model.with_mpsse;
      chip_.set_mode(has_mpsse ? static_cast<std::uint8_t>(value >> 8U) : std::uint8_t{0});
    }
    return n;
  }
  if (request == 0x0a && n >= 1) return data[0] = latency_ms_, 1;
  if (request == 0x05 && n >= 2) return data[0] = 0x01, data[1] = 0x60, 2;
  std::fill_n(data, n, std::uint8_t{0xff});
  return n;
}

// Faults that show before the commands are carried out. True: they are not.
bool Emulator::starts_badly(Fault fault) {
  switch (fault) {
    case Fault::unplug:
      pull_out_next_ = faults_.between(0, 1) == 1;
      if (pull_out_next_) return false;
      pull_out(faults_.between(60, 400) * kNsPerMs);
      return true;
    case Fault::corrupt:
      encoder_.corrupt(static_cast<unsigned>(faults_.between(0, 15)));
      return false;
    case Fault::stuck_low:
      chip_.set_data_line(DataLine::stuck_low);
      return false;
    case Fault::stuck_high:
      chip_.set_data_line(DataLine::stuck_high);
      return false;
    case Fault::nak:
      chip_.refuse_next_i2c_byte();
      return false;
    default:
      return false;
  }
}

void Emulator::ends_badly(Fault fault) {
  chip_.set_data_line(DataLine::works);
  if (fault != Fault::split && fault != Fault::spike && fault != Fault::unplug &&
      fault != Fault::nak) {
    converter_.want_zero(time_.now_ns());
  }
  const std::size_t n = to_host_.size();
  if (n == 0) return;
  if (fault == Fault::cut) {
    to_host_.keep(
        n > 1 ? static_cast<std::size_t>(faults_.between(1, static_cast<std::int64_t>(n) - 1)) : 0);
  } else if (fault == Fault::silent) {
    to_host_.clear();
  } else if (fault == Fault::late) {
    while (to_host_.size() > 0) stale_.put(to_host_.take());
  } else if (fault == Fault::split) {
    first_part_ = (n + 1) / 2;
  } else if (fault == Fault::spike) {
    answer_ns_ = time_.now_ns() + faults_.between(1, 8) * kNsPerMs;
  }
}

int Emulator::bulk_out(std::uint64_t opened, unsigned interface, const std::uint8_t* bytes, int n) {
  constexpr int kShortest = 8;  // longer than what only brings the chip into step
  constexpr std::uint8_t kAnswerAtOnce = 0x87;
  const std::int64_t begun_ns = time_.now_ns();
  time_.pass(kTransferNs + n * kByteNs);
  if (interface != settings_.wired && !gone(opened)) return ++usb_.elsewhere, n;
  ++usb_.out;
  if (gone(opened)) return kNoDevice;
  const bool asks = n > 0 && bytes[n - 1] == kAnswerAtOnce;
  usb_.batches += asks ? 1 : 0;
  Fault fault{};
  const bool has_i2c = std::find(bytes, bytes + n, 0x22) != bytes + n;
  const bool bad = asks && n > kShortest && has_faults() && faults_.sample(fault, has_i2c);
  if (bad && starts_badly(fault)) return kNoDevice;
  while (stale_.size() > 0) to_host_.put(stale_.take());
  const std::uint64_t writes = converter_.writes();
  chip_.take(bytes, static_cast<std::size_t>(n), time_.now_ns(), to_host_);
  if (converter_.writes() != writes) note_voltage(begun_ns);
  if (bad) ends_badly(fault);
  return n;
}

int Emulator::bulk_in(std::uint64_t opened, unsigned interface, std::uint8_t* bytes, int n,
                      int& moved, unsigned timeout_ms) {
  constexpr int kPacket = 512;
  constexpr int kStatus = 2;
  moved = 0;
  time_.pass(kTransferNs);
  if (gone(opened)) return kNoDevice;
  if (interface != settings_.wired) {  // status bytes and nothing more
    time_.pass(latency_ms_ * kNsPerMs);
    ++usb_.elsewhere;
    bytes[moved++] = 0x32;
    bytes[moved++] = 0x60;
    return 0;
  }
  if (pull_out_next_) {
    pull_out(faults_.between(60, 400) * kNsPerMs);
    return kNoDevice;
  }
  const std::int64_t ready = std::max(chip_.busy_until_ns(), answer_ns_);
  const std::int64_t patience = time_.now_ns() + timeout_ms * kNsPerMs;
  if (to_host_.size() > 0 && ready > patience) {
    time_.wait_until(patience);
    return kTimeout;
  }
  if (to_host_.size() > 0) {
    time_.wait_until(ready);
    ++usb_.in;
  } else {
    time_.pass(latency_ms_ * kNsPerMs);  // status bytes when the latency timer is through
    ++usb_.empty;
  }
  std::size_t left = to_host_.size();
  if (first_part_ > 0) left = std::min(left, first_part_);
  first_part_ = 0;
  do {
    const int place = moved;
    bytes[moved++] = 0x32;
    bytes[moved++] = 0x60;
    while (left > 0 && moved < n && moved - place < kPacket) {
      bytes[moved++] = to_host_.take();
      --left;
    }
  } while (left > 0 && moved + kStatus < n);
  time_.pass(moved * kByteNs);
  return 0;
}

}  // namespace eagerx::emulated
