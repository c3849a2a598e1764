// Tables of a large policy as bytes in a file next to its header: the assembler includes them, so
// that the compiler need not parse numbers.
#pragma once

#include <bit>

static_assert(std::endian::native == std::endian::little,
              "the tables of a large policy are little-endian numbers; "
              "`eagerx-gen generate --standalone` writes them as text");

// A section for each table, as for an inline variable: linkers drop it if it is unused, and keep
// one copy if several files include the header.
#ifdef __wasm__
#define EAGERX_STORED_SECTION(symbol)           \
  ".section .rodata." symbol ",\"G\",@," symbol \
  ",comdat\n"                                   \
  ".type " symbol ",@object\n"
#define EAGERX_STORED_END ""
#else
#define EAGERX_STORED_SECTION(symbol)                        \
  ".pushsection .rodata." symbol ",\"aG\",%progbits," symbol \
  ",comdat\n"                                                \
  ".type " symbol ",%object\n"
#define EAGERX_STORED_END ".popsection\n"
#endif

/// Defines the variable with the linker symbol `symbol`: `size` bytes of `file` from `offset` on.
/// With -flto, the assembler may see this several times.
#define EAGERX_STORED_TABLE(symbol, file, offset, size)                                   \
  asm(".ifndef " symbol                                                                   \
      "\n" EAGERX_STORED_SECTION(symbol) ".weak " symbol                                  \
                                         "\n"                                             \
                                         ".hidden " symbol                                \
                                         "\n"                                             \
                                         ".p2align 5\n" symbol                            \
                                         ":\n"                                            \
                                         ".incbin \"" file "\", " offset ", " size        \
                                         "\n"                                             \
                                         ".size " symbol ", " size "\n" EAGERX_STORED_END \
                                         ".endif\n")
