// OpenGL's names of what glEnable switches, and of what other calls set.
#pragma once
#include <string>

#include "mv/gl/functions.h"

namespace mv {

// "GL_DEPTH_TEST", or the number in hexadecimal where it is none of the usual ones.
std::string stateName(GLenum capability);

// "GL_LEQUAL", for the values that draws and the calls of plain state take; else as above. 0 and 1 are the factors GL_ZERO and
// GL_ONE.
std::string valueName(GLenum value);
// "GL_TRIANGLES"
std::string primitiveName(GLenum mode);
// "0xFF"
std::string hexadecimal(GLuint number);

}  // namespace mv
