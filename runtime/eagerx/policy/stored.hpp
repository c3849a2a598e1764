// Tables of a large policy as bytes of a file next to its header: the assembler copies them, and
// the compiler reads no numbers.
#pragma once

#include <bit>

static_assert(std::endian::native == std::endian::little,
              "the file of a policy's tables is for processors with little-endian numbers; "
              "`eagerx-gen generate --standalone` writes them as text");

// Each table is in a section of its own, which linkers leave out if nothing needs it and keep once
// if several files include the header, as they do with inline variables.
#ifdef __wasm__
#define EAGERX_STORED_SECTION(symbol)                                                   \
  ".section .rodata." symbol ",\"G\",@," symbol ",comdat\n.type " symbol ",@object\n"
#define EAGERX_STORED_END ""
#else
#define EAGERX_STORED_SECTION(symbol)                                                        \
  ".pushsection .rodata." symbol ",\"aG\",%progbits," symbol ",comdat\n.type " symbol        \
  ",%object\n"
#define EAGERX_STORED_END ".popsection\n"
#endif

/// Defines `symbol`, a variable's name for the linker: `size` bytes of `file` from `offset` on. The
/// assembler looks for the file in the folders of the compiler's options -I.
#define EAGERX_STORED_TABLE(symbol, file, offset, size)                                    \
  asm(EAGERX_STORED_SECTION(symbol) ".weak " symbol "\n.hidden " symbol                    \
                                    "\n.p2align 5\n" symbol ":\n.incbin \"" file "\", "    \
                                    offset ", " size "\n.size " symbol ", " size           \
                                    "\n" EAGERX_STORED_END)
