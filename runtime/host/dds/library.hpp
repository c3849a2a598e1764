// Cyclone DDS, where it is installed.
#pragma once

#include <cstdint>
#include <string>

namespace eagerx::dds {

// Of Cyclone DDS's headers, versions 0.10: Debian 12 and 13. They are not needed where a program is
// built, and the library not where DDS is unused.

template <class T>
struct Sequence {
  std::uint32_t maximum, length;
  T* buffer;
  bool release;  // whether the library frees the buffer
};
struct SerializedType {
  unsigned char* data;
  std::uint32_t size;
};
/// The library's description of a type: how its members lie in memory.
struct TopicType {
  std::uint32_t size, align, flags, keys = 0;
  const char* name;
  const void* key_names = nullptr;
  std::uint32_t op_count;
  const std::uint32_t* ops;
  const char* meta = "";
  SerializedType information{}, mapping{};
  std::uint32_t representations = 0;
};
struct SampleInfo {
  int sample_state, view_state, instance_state;
  bool is_valid;  // else there is no message in it
  std::int64_t source_ns;
  std::uint64_t instance, publication;
  std::uint32_t counts[5];
};
/// A topic of another participant.
struct Endpoint {
  std::uint8_t key[16], participant[16];
  std::uint64_t participant_instance;
  char* topic_name;
  char* type_name;
  void* qos;
};
struct Matched {
  std::uint32_t total;
  std::int32_t total_change;
  std::uint32_t current;
  std::int32_t current_change;
  std::uint64_t last;
};

/// Of the library: 0 or above, or an error below 0.
using Entity = std::int32_t;
struct Qos;

struct Functions {
  Entity (*create_domain)(std::uint32_t domain, const char* config);
  Entity (*create_participant)(std::uint32_t domain, const Qos* qos, const void* listener);
  Entity (*create_topic)(Entity participant, const TopicType* type, const char* name,
                         const Qos* qos, const void* listener);
  Entity (*create_writer)(Entity participant, Entity topic, const Qos* qos, const void* listener);
  Entity (*create_reader)(Entity participant, Entity topic, const Qos* qos, const void* listener);
  Entity (*create_waitset)(Entity participant);
  Entity (*create_readcondition)(Entity reader, std::uint32_t mask);
  std::int32_t (*waitset_attach)(Entity waitset, Entity entity, std::intptr_t x);
  std::int32_t (*waitset_wait)(Entity waitset, std::intptr_t* xs, std::size_t count,
                               std::int64_t timeout_ns);
  std::int32_t (*write)(Entity writer, const void* message);
  std::int32_t (*take)(Entity reader, void** messages, SampleInfo* infos, std::size_t count,
                       std::uint32_t most);
  std::int32_t (*return_loan)(Entity reader, void** messages, std::int32_t count);
  std::int32_t (*get_subscription_matched_status)(Entity reader, Matched* matched);
  std::int32_t (*get_publication_matched_status)(Entity writer, Matched* matched);
  Entity (*remove)(Entity entity);
  Qos* (*create_qos)();
  void (*delete_qos)(Qos* qos);
  void (*qset_reliability)(Qos* qos, int kind, std::int64_t longest_wait_ns);
  void (*qset_history)(Qos* qos, int kind, std::int32_t depth);
  void (*qset_durability)(Qos* qos, int kind);
  const char* (*strretcode)(std::int32_t code);
};

/// Null, and what is wrong in `problem`: the library is not there.
const Functions* library(std::string& problem);

}  // namespace eagerx::dds
