// The function that main() calls.
#pragma once
namespace mv {

// Runs the demos linked into this program as the command line says; returns the exit status: 0 done, 1 could not (the
// reason is on standard error), 2 the command line is not understood.
int runMain(int count, char** arguments);

}  // namespace mv
