#include "support/live_bytes.h"

#include <malloc.h>

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<std::size_t> live{0};

void* counted(void* memory) {
    if (!memory) throw std::bad_alloc();
    live += malloc_usable_size(memory);
    return memory;
}

void giveBack(void* memory) {
    live -= malloc_usable_size(memory);  // 0 for null
    std::free(memory);
}

}  // namespace

namespace mv::test {
std::size_t liveBytes() { return live; }
}  // namespace mv::test

// The forms that are left out call these.
void* operator new(std::size_t size) { return counted(std::malloc(size == 0 ? 1 : size)); }
void* operator new(std::size_t size, std::align_val_t alignment) {
    const auto step = static_cast<std::size_t>(alignment);
    return counted(std::aligned_alloc(step, (size + step - 1) / step * step));
}
void operator delete(void* memory) noexcept { giveBack(memory); }
void operator delete(void* memory, std::size_t) noexcept { giveBack(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { giveBack(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { giveBack(memory); }
