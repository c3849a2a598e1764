#include <dlfcn.h>

#include <array>
#include <runtime/host/base/look_up.hpp>
#include <runtime/host/web_socket/library.hpp>

namespace eagerx::web_socket {
namespace {

bool find_all(void* library) {
  return look_up(library, "lws_get_library_version", lws.get_library_version) &&
         look_up(library, "lws_set_log_level", lws.set_log_level) &&
         look_up(library, "lws_create_context", lws.create_context) &&
         look_up(library, "lws_create_vhost", lws.create_vhost) &&
         look_up(library, "lws_context_destroy", lws.context_destroy) &&
         look_up(library, "lws_context_user", lws.context_user) &&
         look_up(library, "lws_get_context", lws.get_context) &&
         look_up(library, "lws_adopt_socket_vhost", lws.adopt_socket_vhost) &&
         look_up(library, "lws_service", lws.service) && look_up(library, "lws_write", lws.write) &&
         look_up(library, "lws_callback_on_writable", lws.callback_on_writable) &&
         look_up(library, "lws_send_pipe_choked", lws.send_pipe_choked) &&
         look_up(library, "lws_hdr_copy", lws.hdr_copy) &&
         look_up(library, "lws_hdr_copy_fragment", lws.hdr_copy_fragment) &&
         look_up(library, "lws_is_final_fragment", lws.is_final_fragment) &&
         look_up(library, "lws_remaining_packet_payload", lws.remaining_packet_payload) &&
         look_up(library, "lws_frame_is_binary", lws.frame_is_binary) &&
         look_up(library, "lws_close_reason", lws.close_reason) &&
         look_up(library, "lws_set_timeout", lws.set_timeout) &&
         look_up(library, "lws_add_http_common_headers", lws.add_http_common_headers) &&
         look_up(library, "lws_add_http_header_by_name", lws.add_http_header_by_name) &&
         look_up(library, "lws_finalize_write_http_header", lws.finalize_write_http_header) &&
         look_up(library, "lws_client_connect_via_info", lws.client_connect_via_info) &&
         look_up(library, "lws_get_socket_fd", lws.get_socket_fd);
}

/// Its version of the headers, and no other.
const std::string kVersion =
    std::to_string(LWS_LIBRARY_VERSION_MAJOR) + "." + std::to_string(LWS_LIBRARY_VERSION_MINOR);

}  // namespace

Library lws{};

std::string load() {
  // Versions 4.0, 4.1 and so on; a later one has the name that programs are linked with.
  constexpr std::array kNames = {"libwebsockets.so.16", "libwebsockets.so.17",
                                 "libwebsockets.so.18", "libwebsockets.so.19"};
  const bool is_known = LWS_LIBRARY_VERSION_MAJOR == 4 && LWS_LIBRARY_VERSION_MINOR < 4;
  const char* const name =
      is_known ? kNames[LWS_LIBRARY_VERSION_MINOR % kNames.size()] : "libwebsockets.so";
  void* const library = dlopen(name, RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr || !find_all(library) ||
      std::string(lws.get_library_version()).rfind(kVersion + ".", 0) != 0)
    return "this needs the library libwebsockets " + kVersion +
           ", with which the program was built\nhelp: apt install libwebsockets-dev";
  return {};
}

}  // namespace eagerx::web_socket
