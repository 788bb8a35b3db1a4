// OpenGL's names of what glEnable switches.
#pragma once
#include <string>

#include "mv/gl/functions.h"

namespace mv {

// "GL_DEPTH_TEST", or the number in hexadecimal where it is none of the usual ones.
std::string stateName(GLenum capability);

}  // namespace mv
