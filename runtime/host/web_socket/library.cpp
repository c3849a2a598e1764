#include <dlfcn.h>

#include <array>
#include <runtime/host/web_socket/library.hpp>

namespace eagerx::web_socket {
namespace {

template <class F>
bool find(void* library, const char* name, F& function) {
  function = reinterpret_cast<F>(dlsym(library, name));
  return function != nullptr;
}

bool find_all(void* library) {
  return find(library, "lws_get_library_version", lws.get_library_version) &&
         find(library, "lws_set_log_level", lws.set_log_level) &&
         find(library, "lws_create_context", lws.create_context) &&
         find(library, "lws_create_vhost", lws.create_vhost) &&
         find(library, "lws_context_destroy", lws.context_destroy) &&
         find(library, "lws_context_user", lws.context_user) &&
         find(library, "lws_get_context", lws.get_context) &&
         find(library, "lws_adopt_socket_vhost", lws.adopt_socket_vhost) &&
         find(library, "lws_service", lws.service) && find(library, "lws_write", lws.write) &&
         find(library, "lws_callback_on_writable", lws.callback_on_writable) &&
         find(library, "lws_send_pipe_choked", lws.send_pipe_choked) &&
         find(library, "lws_hdr_copy", lws.hdr_copy) &&
         find(library, "lws_hdr_copy_fragment", lws.hdr_copy_fragment) &&
         find(library, "lws_is_final_fragment", lws.is_final_fragment) &&
         find(library, "lws_remaining_packet_payload", lws.remaining_packet_payload) &&
         find(library, "lws_frame_is_binary", lws.frame_is_binary) &&
         find(library, "lws_close_reason", lws.close_reason) &&
         find(library, "lws_set_timeout", lws.set_timeout) &&
         find(library, "lws_add_http_common_headers", lws.add_http_common_headers) &&
         find(library, "lws_add_http_header_by_name", lws.add_http_header_by_name) &&
         find(library, "lws_finalize_write_http_header", lws.finalize_write_http_header) &&
         find(library, "lws_client_connect_via_info", lws.client_connect_via_info) &&
         find(library, "lws_get_socket_fd", lws.get_socket_fd);
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
