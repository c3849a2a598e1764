// Cyclone DDS: a build needs its headers, and a program that uses DDS needs the library at run
// time. Inside dds/ only.
#pragma once

#include <dds/dds.h>

#include <string>

namespace eagerx::dds {

/// Of the library: 0 or above, or an error below 0.
using Entity = dds_entity_t;
using TopicType = dds_topic_descriptor_t;

struct Functions {
  decltype(&dds_create_domain) create_domain;
  decltype(&dds_create_participant) create_participant;
  decltype(&dds_create_topic) create_topic;
  decltype(&dds_create_writer) create_writer;
  decltype(&dds_create_reader) create_reader;
  decltype(&dds_create_waitset) create_waitset;
  decltype(&dds_create_readcondition) create_readcondition;
  decltype(&dds_waitset_attach) waitset_attach;
  decltype(&dds_waitset_wait) waitset_wait;
  decltype(&dds_write) write;
  decltype(&dds_take) take;
  decltype(&dds_return_loan) return_loan;
  decltype(&dds_get_subscription_matched_status) get_subscription_matched_status;
  decltype(&dds_get_publication_matched_status) get_publication_matched_status;
  decltype(&dds_delete) remove;
  decltype(&dds_create_qos) create_qos;
  decltype(&dds_delete_qos) delete_qos;
  decltype(&dds_qset_reliability) qset_reliability;
  decltype(&dds_qset_history) qset_history;
  decltype(&dds_qset_durability) qset_durability;
  decltype(&dds_strretcode) strretcode;
};

/// Null and a `problem` if the library is missing.
const Functions* library(std::string& problem);

}  // namespace eagerx::dds
