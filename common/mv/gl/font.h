// DejaVu Sans, embedded at build time from Debian's fonts-dejavu-core.
#pragma once
#include <cstddef>
#include <span>

namespace mv {

// The font file. The window's panel uses it too, so that words look the same in the picture and beside it.
std::span<const std::byte> fontFile();

}  // namespace mv
