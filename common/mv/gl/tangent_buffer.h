// Tangents on the GPU, beside the mesh that they belong to.
#pragma once
#include <span>
#include <string>

#include "mv/gl/object.h"
#include "mv/math/types.h"

namespace mv {

// The location of the vertex attribute that shaders declare as `in vec4 tangent`.
inline constexpr GLuint tangentLocation = 4;

// Uploads meshTangents(...).tangents as one more attribute of the vertex array that is bound: that of a Mesh which was
// made just now of meshTangents(...).mesh. The buffer has to live as long as that mesh. Error: no vertex array is bound,
// or no tangents.
Buffer attachTangents(std::span<const fvec4> tangents, const std::string& label);

}  // namespace mv
