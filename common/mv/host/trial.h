// A host that may take the program down with it is opened in a child process first.
#pragma once
#include <functional>
#include <memory>
#include <string>

#include "mv/host/context.h"

namespace mv {

// Opens a context by `open`. A child process does it first where the environment steers the driver (GALLIUM_DRIVER,
// MESA_..., LIBGL_... and the like), and draws with it: some values end Mesa by a signal, in the midst of making a
// context. Elsewhere nothing is tried, and no time is spent. Error: as `open`; or a signal or an exit of the driver's
// ended the child, with the variables' names; or the system gives no threads, for which a driver would wait for ever, or
// too little memory (ulimit).
std::unique_ptr<Context> openTried(const std::string& host, const std::function<std::unique_ptr<Context>()>& open);

// Ends the program by a sentence and with status 1 where its limits of stack and data (ulimit -s, -d) are less than what it
// needs to begin. It allocates nothing, and needs nothing static.
void requireRoom();

// From now on a fault that ends the program is told in a sentence, and the status is 1: a driver's compiler that has no more memory
// or stack, a variable that it does not bear. A debugger still sees the signal first. Handlers that are there stay.
void tellOfFaults();

}  // namespace mv
