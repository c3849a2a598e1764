// The operands of an instruction as objdump prints them.
#pragma once

#include <initializer_list>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "generator/analysis/bound/image.hpp"
#include "generator/analysis/bound/value.hpp"

namespace eagerx::gen::bound {

/// "#12"; nullopt: something else.
std::optional<std::int64_t> number_of(std::string_view operand);
/// The lowest 32 bits, with a sign.
std::int64_t as_signed(std::int64_t value);
/// Fills in what name and operands mean.
void decode(Instruction& instruction);
/// Registers of "{r4, r5-r7, lr}".
std::vector<std::size_t> listed_registers(std::string_view list);
/// The first and the last of "{d8-d11}".
std::pair<std::size_t, std::size_t> range_of_doubles(std::string_view list);
bool starts_with_any(std::string_view name, std::initializer_list<std::string_view> beginnings);

}  // namespace eagerx::gen::bound
