// A libOSMesa.so.8 that takes the program down in the midst of making a context, as Mesa's does for some variables: by a signal,
// or by an exit with the status that OSMESA_EXIT says.
#include <unistd.h>

#include <csignal>
#include <cstdlib>

using Function = void (*)();

extern "C" {
void* OSMesaCreateContextAttribs(const int*, void*) {
    if (const char* status = std::getenv("OSMESA_EXIT")) _exit(std::atoi(status));
    std::raise(SIGSEGV);
    return nullptr;
}
unsigned char OSMesaMakeCurrent(void*, void*, unsigned, int, int) { return 0; }
void OSMesaDestroyContext(void*) {}
Function OSMesaGetProcAddress(const char*) { return nullptr; }
}
