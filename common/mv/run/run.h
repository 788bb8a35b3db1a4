// The functions that a program calls.
#pragma once
namespace mv {

// Runs the demos linked into this program as the command line says; returns the exit status: 0 done, 1 could not (the
// reason is on standard error), 2 the command line is not understood.
int runMain(int count, char** arguments);

// To be called before what is static is made, in libraries and in the tables of the demos, which need room, too: ends the program
// by a sentence and with status 1 where the system allows it too little stack or memory to begin (ulimit -s, -d).
void beforeAll();

}  // namespace mv
