#include "generator/tools/serve/http.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <filesystem>

namespace eagerx::gen::serve {

std::unique_ptr<HttpServer> load_http(const std::string& module, std::string& problem) {
  std::error_code error;
  if (!std::filesystem::exists(module, error)) {
    problem =
        "error: this eagerx-gen was built without a server\nhelp: install libcpp-httplib-dev and "
        "build it again";
    return nullptr;
  }
  void* const library = dlopen(module.c_str(), RTLD_NOW | RTLD_LOCAL);
  void* const symbol = library != nullptr ? dlsym(library, "eagerx_http_server") : nullptr;
  if (symbol == nullptr) {
    const char* const why = dlerror();
    problem = fmt::format(
        "error: the server cannot be loaded: {}\nhelp: install libcpp-httplib-dev, which has the "
        "library",
        why != nullptr ? why : module);
    return nullptr;
  }
  return std::unique_ptr<HttpServer>(reinterpret_cast<MakeHttpServer>(symbol)());
}

}  // namespace eagerx::gen::serve
