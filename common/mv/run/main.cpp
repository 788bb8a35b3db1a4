#include "mv/run/run.h"

// What stands in this section runs before all constructors, also those of libraries.
[[gnu::section(".preinit_array"), gnu::used]] static void (*const first)() = mv::beforeAll;

int main(int count, char** arguments) { return mv::runMain(count, arguments); }
