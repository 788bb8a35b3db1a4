# Read once instead of in every file: half of what compiling a demo takes; and no more than what nearly each file takes, since what is
# precompiled is read in anew for each. No file relies on it; static analysis compiles them without.
set(MVGL_PRECOMPILED <algorithm> <cmath> <functional> <memory> <string> <vector> <glm/glm.hpp>)
# Of ours what nearly every demo includes. Not where ccache keeps what is compiled: it goes by contents, and g++ by
# dates when it asks whether a file with #pragma once is the one that was precompiled; a header changed there and back
# is read twice.
set(MVGL_PRECOMPILED_DEMO "")
if(NOT CMAKE_CXX_COMPILER_LAUNCHER MATCHES ccache)
  set(MVGL_PRECOMPILED_DEMO <mv/demo/demo.h> <mv/gl/gl.h>)
endif()
