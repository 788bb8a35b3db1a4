#include "mv/run/run.h"

int main(int count, char** arguments) { return mv::runMain(count, arguments); }
