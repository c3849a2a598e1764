// Adds a number to a message's checksum.
#pragma once

namespace oracle {

template <class Io>
struct AddProc {
  static typename Io::Output convert(const typename Io::Input& in) {
    return {{in[0], in[1] + Io::Config::k}};
  }
};

}  // namespace oracle
