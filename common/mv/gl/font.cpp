#include "mv/gl/font.h"

// The build names the font file; the assembler copies it in, which costs no compile time.
__asm__(
    ".pushsection .rodata\n"
    ".global mv_font_begin\n"
    ".global mv_font_end\n"
    "mv_font_begin:\n"
    ".incbin \"" MVGL_FONT_FILE
    "\"\n"
    "mv_font_end:\n"
    ".popsection\n");

extern "C" const std::byte mv_font_begin[] __attribute__((visibility("hidden")));
extern "C" const std::byte mv_font_end[] __attribute__((visibility("hidden")));

namespace mv {

std::span<const std::byte> fontFile() { return {mv_font_begin, mv_font_end}; }

}  // namespace mv
