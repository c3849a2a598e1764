// libwebsockets: a build needs its headers, because its structs differ between versions, and a
// program that uses WebSockets needs the library at run time. Inside web_socket/ only.
#pragma once

#include <libwebsockets.h>

#include <string>

namespace eagerx::web_socket {

struct Library {
  decltype(&lws_get_library_version) get_library_version;
  decltype(&lws_set_log_level) set_log_level;
  decltype(&lws_create_context) create_context;
  decltype(&lws_create_vhost) create_vhost;
  decltype(&lws_context_destroy) context_destroy;
  decltype(&lws_context_user) context_user;
  decltype(&lws_get_context) get_context;
  decltype(&lws_adopt_socket_vhost) adopt_socket_vhost;
  decltype(&lws_service) service;
  decltype(&lws_write) write;
  decltype(&lws_callback_on_writable) callback_on_writable;
  decltype(&lws_send_pipe_choked) send_pipe_choked;
  decltype(&lws_hdr_copy) hdr_copy;
  decltype(&lws_hdr_copy_fragment) hdr_copy_fragment;
  decltype(&lws_is_final_fragment) is_final_fragment;
  decltype(&lws_remaining_packet_payload) remaining_packet_payload;
  decltype(&lws_frame_is_binary) frame_is_binary;
  decltype(&lws_close_reason) close_reason;
  decltype(&lws_set_timeout) set_timeout;
  decltype(&lws_add_http_common_headers) add_http_common_headers;
  decltype(&lws_add_http_header_by_name) add_http_header_by_name;
  decltype(&lws_finalize_write_http_header) finalize_write_http_header;
  decltype(&lws_client_connect_via_info) client_connect_via_info;
  decltype(&lws_get_socket_fd) get_socket_fd;
};
extern Library lws;  // of the one library

/// Pings a peer that is idle for 10 s, and drops it after 30 s.
inline constexpr lws_retry_bo_t kAliveness{nullptr, 0, 0, 10, 30, 0};

/// Loads it. Empty, or the problem.
std::string load();

}  // namespace eagerx::web_socket
