// A page reads numbers by the browser: the C library's own way goes through long doubles, which WebAssembly computes by functions.
#include "mv/portable_number.h"

#include <emscripten.h>

EM_JS(double, browserNumber, (const char* text), { return Number(UTF8ToString(text)); });

namespace mv::portable {

double nearestDouble(const char* text) { return browserNumber(text); }

}  // namespace mv::portable
