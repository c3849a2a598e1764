// The message itself.
#pragma once

namespace eagerx::models {

/// Passes every message on unchanged.
template <class Io>
struct Identity {
  static typename Io::Output convert(const typename Io::Input& in) { return in; }
};

}  // namespace eagerx::models
