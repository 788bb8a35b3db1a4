// Whether this is compiled under the sanitizers: what they look for is found by fewer and smaller pictures than what is tested of them.
#pragma once

namespace mv::test {

#ifdef MVGL_SANITIZED
constexpr bool sanitized = true;
#else
constexpr bool sanitized = false;
#endif

}  // namespace mv::test
