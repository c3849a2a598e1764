// Reports bugs of eagerx-gen as such, however they end the program.
#pragma once

#include <functional>

namespace eagerx::gen {

/// The exit code of `action`, the whole work of a main function. If it throws or aborts (most of
/// the generator is compiled without exceptions, so that a wrong `std::get` aborts), the code is
/// kInternal, and a line on stderr asks for a report.
int reporting_bugs(const char* program, const std::function<int()>& action);

}  // namespace eagerx::gen
