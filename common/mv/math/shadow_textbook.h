// The matrices of planar shadows as the lecture has them, without a check and in either precision: for comparison with
// shadowProjection in mv/math/shadow.h, which is what a program should use.
//
// Light and plane as there, but the normal of the plane must have unit length and point to the light's side; else the
// result is scaled, or turned to w' < 0.
#pragma once
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

namespace mv {

// n.L I - L n^T for the plane n = (a, b, c, d): row i has L_i (a, b, c, d) taken from the diagonal. With `transposed` it
// is what the lecture prints, rows n_i (L_x, L_y, L_z, L_w): right for row vectors, and wrong for P = M V.
template <class T>
glm::mat<4, 4, T> textbookShadow(const glm::vec<4, T>& light, const glm::vec<4, T>& plane, bool transposed = false) {
    glm::mat<4, 4, T> m(glm::dot(plane, light));
    for (int column = 0; column < 4; ++column) m[column] -= transposed ? plane * light[column] : light * plane[column];
    return m;
}

// The lecture's special case, a plane across axis k, where coordinate k is q: by similar triangles
// P_j = ((L_k - q) V_j - L_j (V_k - q)) / (L_k - V_k) and P_k = q. The axis is that of the normal's largest component;
// the others are taken for 0.
template <class T>
glm::mat<4, 4, T> textbookShadowAcrossAxis(const glm::vec<4, T>& light, const glm::vec<4, T>& plane) {
    int k = 0;
    for (const int axis : {1, 2}) k = std::abs(plane[axis]) > std::abs(plane[k]) ? axis : k;
    const T side = plane[k] < 0 ? T(-1) : T(1);
    const T q = -side * plane.w;
    glm::mat<4, 4, T> m(light[k] - q * light.w);
    for (int j = 0; j < 3; ++j) {
        m[k][j] = -light[j];
        m[3][j] = q * light[j];
    }
    m[k][k] = -q * light.w;  // row k is q times row 4, so that P_k = q
    m[k][3] = -light.w;
    m[3][3] = light[k];
    return side * m;
}

}  // namespace mv
