#include <dirent.h>
#include <ifaddrs.h>
#include <net/if.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <map>
#include <runtime/host/base/background.hpp>
#include <runtime/host/dds/participant.hpp>
#include <set>
#include <vector>

namespace eagerx::dds {
namespace {

constexpr const char* kOfUser = "CYCLONEDDS_URI";

bool is_address(std::string_view text) {
  return text.find_first_not_of("0123456789.") == std::string_view::npos;
}
bool is_loopback(std::string_view interface) {
  return interface.empty() || interface == "lo" || interface.starts_with("127.");
}

/// The interfaces of this machine that are up, the loopback first, in the library's form; it has at
/// most 4. Others of this machine say that they are at one of these addresses.
std::string interfaces() {
  constexpr std::size_t kMost = 4;
  std::vector<std::string> names{"lo"};
  ifaddrs* all = nullptr;
  if (getifaddrs(&all) != 0) return names[0];
  for (const ifaddrs* each = all; each != nullptr; each = each->ifa_next) {
    const bool is_known = std::find(names.begin(), names.end(), each->ifa_name) != names.end();
    if (each->ifa_addr != nullptr && each->ifa_addr->sa_family == AF_INET &&
        (each->ifa_flags & IFF_RUNNING) != 0 && !is_known && is_interface(each->ifa_name))
      names.emplace_back(each->ifa_name);
  }
  freeifaddrs(all);
  names.resize(std::min(names.size(), kMost));
  std::string text;
  for (const std::string& name : names) text += "<NetworkInterface name=\"" + name + "\"/>";
  return text;
}

/// Multicast is unused: participants of this machine are asked, by the ports that DDS gives to its
/// participants.
std::string this_machine() {
  return "<General><Interfaces>" + interfaces() +
         "</Interfaces><AllowMulticast>false</AllowMulticast></General>"
         "<Discovery><ParticipantIndex>auto</ParticipantIndex>"
         "<MaxAutoParticipantIndex>32</MaxAutoParticipantIndex>"
         "<Peers><Peer address=\"127.0.0.1\"/></Peers></Discovery>";
}

std::string config_of(const Network& network) {
  const std::string& to = network.interface;
  const std::string settings = is_loopback(to)
                                   ? this_machine()
                                   : "<General><Interfaces><NetworkInterface " +
                                         std::string(is_address(to) ? "address" : "name") + "=\"" +
                                         to + "\"/></Interfaces></General>";
  return "<CycloneDDS><Domain Id=\"any\">" + settings +
         // It would say so for each message of somebody else that is none. Without a name it makes
         // a file in the working folder.
         "<Tracing><Verbosity>severe</Verbosity><OutputFile>stderr</OutputFile></Tracing></Domain>"
         "</CycloneDDS>";
}

/// All file descriptors.
std::set<int> descriptors() {
  std::set<int> found;
  DIR* const folder = opendir("/proc/self/fd");
  if (folder == nullptr) return found;
  while (const dirent* const entry = readdir(folder)) found.insert(std::atoi(entry->d_name));
  found.erase(dirfd(folder));  // the next file has its number
  closedir(folder);
  return found;
}
/// The library hears every interface, whichever one it is given. Its sockets, those that were not
/// there before, hear this machine only from now on. 0, or an errno.
int hear_this_machine(const std::set<int>& before) {
  constexpr char kLoopback[] = "lo";
  for (const int each : descriptors()) {
    sockaddr_in address{};
    socklen_t size = sizeof(address);
    if (before.contains(each) ||
        getsockname(each, reinterpret_cast<sockaddr*>(&address), &size) != 0 ||
        address.sin_family != AF_INET || address.sin_addr.s_addr != INADDR_ANY)
      continue;
    if (setsockopt(each, SOL_SOCKET, SO_BINDTODEVICE, kLoopback, sizeof(kLoopback)) != 0)
      return errno;
  }
  return 0;
}

}  // namespace

/// A program is in a domain once, in one network.
struct Participant::Domain {
  const Functions& functions;
  std::string config;
  Entity id;

  ~Domain() { functions.remove(id); }
};

Participant::~Participant() {
  if (functions_ != nullptr && id_ >= 0) functions_->remove(id_);
}

std::string Participant::open(const Network& network, bool alone) {
  std::string problem;
  functions_ = library(problem);
  if (functions_ == nullptr) return problem;
  const char* const of_user = std::getenv(kOfUser);
  const bool as_user_says =
      !alone && network.interface.empty() && of_user != nullptr && *of_user != '\0';
  if (as_user_says) {
    reach_ = "where CYCLONEDDS_URI says";
  } else if (!is_loopback(network.interface)) {
    reach_ = "on `" + network.interface + "`, to everybody there";
  }
  // The threads of the library are like those of ours.
  host::thread_without_signals([&] {
    problem = join(network, as_user_says ? std::string() : config_of(network));
  }).join();
  return problem;
}

std::string Participant::join(const Network& network, const std::string& config) {
  static std::map<std::uint32_t, std::weak_ptr<Domain>> domains;
  const std::string name = "domain " + std::to_string(network.domain) + " of DDS";
  const std::set<int> before = descriptors();
  auto& known = domains[network.domain];
  domain_ = known.lock();
  if (domain_ == nullptr) {
    Entity id = 0;
    if (!config.empty()) id = functions_->create_domain(network.domain, config.c_str());
    if (id < 0) return "error: cannot join " + name + ": " + functions_->strretcode(id);
    domain_ = std::shared_ptr<Domain>(new Domain{*functions_, config, id});
    known = domain_;
  } else if (domain_->config != config) {
    return "error: " + name + " is in two networks\nhelp: give each its own domain";
  }
  id_ = functions_->create_participant(network.domain, nullptr, nullptr);
  if (id_ < 0) return "error: cannot join " + name + ": " + functions_->strretcode(id_);
  const int error =
      config.empty() || !is_loopback(network.interface) ? 0 : hear_this_machine(before);
  if (error == 0) return {};
  return "error: cannot keep " + name + " on this machine: " + std::strerror(error);
}

template <class Make>
Entity Participant::endpoint(const TopicType& type, const std::string& topic, Promise promise,
                             Make make) {
  const Functions& f = *functions_;
  const Entity id = f.create_topic(id_, &type, topic.c_str(), nullptr, nullptr);
  if (id < 0) return id;
  dds_qos_t* const qos = f.create_qos();
  const bool is_reliable = promise == Promise::event || promise == Promise::exchange;
  // A writer does not wait for a reader: without room it says so at once.
  f.qset_reliability(qos, is_reliable ? DDS_RELIABILITY_RELIABLE : DDS_RELIABILITY_BEST_EFFORT, 0);
  f.qset_history(qos, DDS_HISTORY_KEEP_LAST,
                 promise == Promise::clock      ? 1
                 : promise == Promise::exchange ? 16
                                                : 5);
  f.qset_durability(
      qos, promise == Promise::event ? DDS_DURABILITY_TRANSIENT_LOCAL : DDS_DURABILITY_VOLATILE);
  const Entity made = make(id, qos);
  f.delete_qos(qos);
  f.remove(id);  // what was made keeps it
  return made;
}
Entity Participant::writer(const TopicType& type, const std::string& topic, Promise promise) {
  return endpoint(type, topic, promise, [&](Entity id, const dds_qos_t* qos) {
    return functions_->create_writer(id_, id, qos, nullptr);
  });
}
Entity Participant::reader(const TopicType& type, const std::string& topic, Promise promise) {
  return endpoint(type, topic, promise, [&](Entity id, const dds_qos_t* qos) {
    return functions_->create_reader(id_, id, qos, nullptr);
  });
}

std::string Participant::problem(Entity error, const std::string& topic) const {
  return "error: DDS has no topic `" + topic + "`: " + functions_->strretcode(error);
}

}  // namespace eagerx::dds
