// A server of Foxglove's WebSocket protocol: channels, the drawing, time, parameters, services. It
// can also serve a page, which uses the same protocol.
#pragma once

#include <cstdint>
#include <memory>
#include <runtime/host/foxglove/server_text.hpp>
#include <runtime/host/foxglove/steering.hpp>
#include <runtime/host/publish/address.hpp>
#include <runtime/host/publish/sink.hpp>
#include <string>
#include <vector>

namespace eagerx::foxglove {

/// A page for a browser of this machine, and the key that reading requires.
struct Site {
  std::string page;  // HTML; empty: there is none
  std::string key;
};

/// The served data. Everything that it points to must outlive the server.
struct Served {
  std::string graph, engine;
  std::uint64_t graph_hash = 0;
  const publish::PublishedChannels* channels = nullptr;
  std::vector<bool> chosen;      // [channels]
  bool has_scene = false;        // the topics `/scene` and `/drawing`
  std::vector<Topic> topics;     // whose messages say() gives
  Steering* steering = nullptr;  // null: nothing can be changed
  bool is_real = false;          // something real moves
  std::string key_file;          // of who may change the run; empty: none
  Site site = {};
};

class Server : public publish::PublishSink {
 public:
  /// Its address, once it is open: `http://127.0.0.1:8765`
  virtual std::string address() const = 0;
  /// A message of the topic with this place in Served::topics.
  virtual void say(std::size_t topic, std::int64_t time_ns, const std::string& json) = 0;
};

/// `to.port` may be 0: any that is free.
std::unique_ptr<Server> server(const publish::Address& to, Served served);

}  // namespace eagerx::foxglove
