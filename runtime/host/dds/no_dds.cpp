// Replaces the other files where Cyclone DDS is not installed.
#include <runtime/host/dds/dds_sink.hpp>
#include <runtime/host/dds/joint_exchange.hpp>

namespace eagerx::dds {
namespace {

constexpr const char* kProblem =
    "error: this program was built without Cyclone DDS\n"
    "help: apt install cyclonedds-dev cyclonedds-tools, and build it again";

class NoSink final : public publish::PublishSink {
 public:
  std::string open() override { return kProblem; }
  void message(const publish::PublishedMessage& /*message*/) override {}
  void step(const publish::PublishedStep& /*step*/) override {}
  const char* unit() const override { return "messages"; }
};

class NoExchange final : public JointExchange {
 public:
  std::string open(std::uint32_t /*domain*/, const std::vector<std::string>& /*inputs*/,
                   const std::vector<Output>& /*outputs*/) override {
    return kProblem;
  }
  bool is_there() const override { return false; }
  bool write(std::size_t /*output*/, Stamp /*time*/, std::string& /*frame*/,
             std::span<double> /*positions*/) override {
    return false;
  }
  void read(std::size_t /*input*/, const Take& /*take*/) override {}
  void wait(std::int64_t /*most_ns*/) override {}
  std::vector<std::string> strangers() override { return {}; }
};

}  // namespace

std::unique_ptr<publish::PublishSink> topic_sink(const Network& /*to*/, std::string /*said*/,
                                                 const publish::PublishedChannels& /*channels*/,
                                                 const Graph& /*graph*/,
                                                 std::vector<bool> /*chosen*/) {
  return std::make_unique<NoSink>();
}

std::unique_ptr<JointExchange> joint_exchange() {
  return std::make_unique<NoExchange>();
}

}  // namespace eagerx::dds
