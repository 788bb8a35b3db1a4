// The vector and matrix types of mvgl: GLM's, in double precision.
//
// MV.js computes in doubles and rounds once, when flatten() makes the Float32Array; mvgl does the same: all of
// mv/math works in doubles and Program::set rounds at the upload. A mat4 is column-major, m[column][row], and
// multiplies column vectors: clipFromModel * position.
#pragma once
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace mv {

using vec2 = glm::dvec2;
using vec3 = glm::dvec3;
using vec4 = glm::dvec4;
using mat3 = glm::dmat3;
using mat4 = glm::dmat4;

// The types that the GPU stores: vertex data and uploaded matrices.
using fvec2 = glm::vec2;
using fvec3 = glm::vec3;
using fvec4 = glm::vec4;
using fmat3 = glm::mat3;
using fmat4 = glm::mat4;

inline constexpr double pi = 3.14159265358979323846;

// Degrees are the unit of every angle in mvgl, as in MV.js; these two stand where a formula needs radians.
constexpr double radians(double degrees) { return degrees * (pi / 180.0); }
constexpr double degrees(double radians) { return radians * (180.0 / pi); }

}  // namespace mv
