#include <dlfcn.h>

#include <runtime/host/base/look_up.hpp>
#include <runtime/host/dds/library.hpp>

namespace eagerx::dds {
namespace {

/// Both Debians have this name; another maker's library may be of another version.
constexpr const char* kFile = "libddsc.so.0debian";

bool look_up_all(void* library, Functions& f) {
  return look_up(library, "dds_create_domain", f.create_domain) &&
         look_up(library, "dds_create_participant", f.create_participant) &&
         look_up(library, "dds_create_topic", f.create_topic) &&
         look_up(library, "dds_create_writer", f.create_writer) &&
         look_up(library, "dds_create_reader", f.create_reader) &&
         look_up(library, "dds_create_waitset", f.create_waitset) &&
         look_up(library, "dds_create_readcondition", f.create_readcondition) &&
         look_up(library, "dds_waitset_attach", f.waitset_attach) &&
         look_up(library, "dds_waitset_wait", f.waitset_wait) &&
         look_up(library, "dds_write", f.write) && look_up(library, "dds_take", f.take) &&
         look_up(library, "dds_return_loan", f.return_loan) &&
         look_up(library, "dds_get_subscription_matched_status",
                 f.get_subscription_matched_status) &&
         look_up(library, "dds_get_publication_matched_status", f.get_publication_matched_status) &&
         look_up(library, "dds_delete", f.remove) &&
         look_up(library, "dds_create_qos", f.create_qos) &&
         look_up(library, "dds_delete_qos", f.delete_qos) &&
         look_up(library, "dds_qset_reliability", f.qset_reliability) &&
         look_up(library, "dds_qset_history", f.qset_history) &&
         look_up(library, "dds_qset_durability", f.qset_durability) &&
         look_up(library, "dds_strretcode", f.strretcode);
}

}  // namespace

const Functions* library(std::string& problem) {
  static Functions functions;
  static const bool found = [] {
    void* const opened = dlopen(kFile, RTLD_NOW | RTLD_LOCAL);
    return opened != nullptr && look_up_all(opened, functions);
  }();
  if (!found)
    problem = "error: DDS needs the library Cyclone DDS, `" + std::string(kFile) +
              "`\nhelp: apt install cyclonedds-tools, which brings it";
  return found ? &functions : nullptr;
}

}  // namespace eagerx::dds
