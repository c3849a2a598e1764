// Instructions, control flow, loops and longest paths, of disassemblies as objdump prints them.
#include "generator/analysis/bound/path.hpp"

#include <gtest/gtest.h>

namespace eagerx::gen::bound {
namespace {}  // namespace
}  // namespace eagerx::gen::bound
