// Loaded before the sanitized programs (LD_PRELOAD): no library is unmapped. GLFW closes those of the display at its end,
// and of a library that is gone LeakSanitizer can neither name what it has left allocated nor find what still holds it.
extern "C" int dlclose(void*) { return 0; }
