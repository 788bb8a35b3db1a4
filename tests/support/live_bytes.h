// The bytes that a test program has of operator new and has not given back.
#pragma once
#include <cstddef>

namespace mv::test {

// Bytes, as the allocator rounds them up. A program that links this counts all of its C++: the library's, the demos' and
// the driver's compiler, which is C++ too; not what drivers take by malloc, and keep for later as they like.
std::size_t liveBytes();

}  // namespace mv::test
