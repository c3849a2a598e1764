#include <exception>
#include <new>
#include <string>
#include <system_error>
#include <targets/environments/base/problem.hpp>

namespace eagerx::environments {
namespace {

std::string& last_error() {
  thread_local std::string text;
  return text;
}

/// Only threads throw these.
int fail_without_threads(const std::error_code& why) noexcept {
  try {
    last_error() = "the system gives no more threads: " + why.message();
  } catch (...) {
    last_error().clear();
  }
  return -1;
}

}  // namespace

void refuse(const char* text) {
  throw Problem(text);
}
void refuse(const std::string& text) {
  throw Problem(text);
}

const char* error_text() {
  return last_error().c_str();
}
void set_error(const std::string& text) {
  last_error() = text;
}

int fail(const char* text) noexcept {
  try {
    last_error() = text;
  } catch (...) {
    last_error().clear();
  }
  return -1;
}

int fail_as_caught() noexcept {
  try {
    throw;
  } catch (const std::bad_alloc&) {
    return fail("not enough memory");
  } catch (const std::system_error& problem) {
    return fail_without_threads(problem.code());
  } catch (const std::exception& problem) {
    return fail(problem.what());
  } catch (...) {
    return fail("something unknown was thrown");
  }
}

}  // namespace eagerx::environments
