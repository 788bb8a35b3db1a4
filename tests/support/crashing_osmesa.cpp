// A libOSMesa.so.8 that takes the program down in the midst of making a context, as Mesa's does for some variables.
#include <csignal>

using Function = void (*)();

extern "C" {
void* OSMesaCreateContextAttribs(const int*, void*) {
    std::raise(SIGSEGV);
    return nullptr;
}
unsigned char OSMesaMakeCurrent(void*, void*, unsigned, int, int) { return 0; }
void OSMesaDestroyContext(void*) {}
Function OSMesaGetProcAddress(const char*) { return nullptr; }
}
