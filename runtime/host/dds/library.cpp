#include <dlfcn.h>

#include <runtime/host/base/look_up.hpp>
#include <runtime/host/dds/library.hpp>

namespace eagerx::dds {
namespace {

/// The name that a program is linked with: of the version whose headers are used here.
constexpr const char* kFile = EAGERX_DDSC;

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
    problem =
        "error: DDS needs the library Cyclone DDS, `" + std::string(kFile) +
        "`, with which the program was built\nhelp: apt install cyclonedds-dev, which brings it";
  return found ? &functions : nullptr;
}

}  // namespace eagerx::dds
