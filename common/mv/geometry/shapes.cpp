#include "mv/geometry/shapes.h"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>

#include "mv/error.h"
#include "mv/math/require.h"
#include "mv/math/robust.h"

namespace mv {
namespace {

// Room below the largest float, 3.4e38, for sums of a few sizes.
constexpr double largestSize = 1e38;
constexpr int mostDivisions = 4096;

// The corners of a cube as -1 or 1, numbered as in the course; v0 to v3 are the square nearest the eye.
constexpr std::array<std::array<int, 3>, 8> cubeCorners{
    {{-1, -1, 1}, {-1, 1, 1}, {1, 1, 1}, {1, -1, 1}, {-1, -1, -1}, {-1, 1, -1}, {1, 1, -1}, {1, -1, -1}}};

// A face of the cube: its corners counter-clockwise seen from outside, and the directions of a picture on it.
struct BoxSide {
    std::array<std::size_t, 4> corners;
    fvec3 normal, right, up;
};

const std::array<BoxSide, 6> boxSides{{{{1, 0, 3, 2}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}},
                                       {{2, 3, 7, 6}, {1, 0, 0}, {0, 0, -1}, {0, 1, 0}},
                                       {{3, 0, 4, 7}, {0, -1, 0}, {1, 0, 0}, {0, 0, 1}},
                                       {{6, 5, 1, 2}, {0, 1, 0}, {1, 0, 0}, {0, 0, -1}},
                                       {{4, 5, 6, 7}, {0, 0, -1}, {-1, 0, 0}, {0, 1, 0}},
                                       {{5, 4, 0, 1}, {-1, 0, 0}, {0, 0, 1}, {0, 1, 0}}}};

// A quadrilateral a, b, c, d is drawn as the triangles a b c and a c d.
constexpr std::array<std::size_t, 6> quadOrder{0, 1, 2, 0, 2, 3};

fvec3 cornerOf(std::size_t corner) {
    const auto& c = cubeCorners[corner];
    return fvec3(c[0], c[1], c[2]);
}

void requireSize(std::string_view subject, std::string_view name, double value, double least) {
    if (value >= least && value <= largestSize) return;  // false for NaN
    throw Error(subject, std::string(name) + " must be " + numberText(least) + " to " + numberText(largestSize),
                numberText(value));
}

// Point i of n around the unit circle; n is point 0 again, to the last bit.
vec2 onCircle(int i, int n) {
    const double angle = 2 * pi * (i == n ? 0 : i) / n;
    return {std::cos(angle), std::sin(angle)};
}

// A row of vertices around the y axis: slices + 1 of them, the first again at the end of the seam, or, on the axis, one
// in the middle of each slice.
struct Row {
    std::uint32_t first = 0;
    bool pole = false;
};

// Two triangles a cell between two rows, one where a pole has taken the other's edge away.
void joinRows(MeshData& mesh, const Row& lower, const Row& upper, int slices) {
    for (int i = 0; i < slices; ++i) {
        const std::uint32_t south = lower.first + static_cast<std::uint32_t>(i);
        const std::uint32_t north = upper.first + static_cast<std::uint32_t>(i);
        if (!lower.pole) mesh.indices.insert(mesh.indices.end(), {south, south + 1, north});
        if (lower.pole) {
            mesh.indices.insert(mesh.indices.end(), {south, north + 1, north});
        } else if (!upper.pole) {
            mesh.indices.insert(mesh.indices.end(), {south + 1, north + 1, north});
        }
    }
}

}  // namespace

MeshData colorCube() {
    static const std::array<fvec4, 8> colors{fvec4(0, 0, 0, 1), fvec4(1, 0, 0, 1), fvec4(1, 1, 0, 1), fvec4(0, 1, 0, 1),
                                             fvec4(0, 0, 1, 1), fvec4(1, 0, 1, 1), fvec4(0, 1, 1, 1), fvec4(1)};
    MeshData mesh;
    for (const BoxSide& face : boxSides) {
        for (const std::size_t i : quadOrder) {
            mesh.positions.push_back(0.5f * cornerOf(face.corners[i]));
            mesh.colors.push_back(colors[face.corners[0]]);
        }
    }
    return mesh;
}

MeshData wireCube() {
    static constexpr std::array<std::size_t, 24> ends{0, 1, 1, 2, 2, 3, 3, 0, 4, 5, 5, 6,
                                                      6, 7, 7, 4, 0, 4, 1, 5, 2, 6, 3, 7};
    MeshData mesh;
    mesh.primitive = Primitive::lines;
    for (const std::size_t end : ends) mesh.positions.push_back(0.5f * cornerOf(end));
    return mesh;
}

MeshData square() {
    static const std::array<fvec2, 4> texCoords{fvec2(0, 0), fvec2(1, 0), fvec2(1, 1), fvec2(0, 1)};
    MeshData mesh;
    for (const std::size_t i : quadOrder) {
        mesh.positions.emplace_back(texCoords[i].x - 0.5f, 0, 0.5f - texCoords[i].y);
        mesh.normals.emplace_back(0, 1, 0);
        mesh.texCoords.push_back(texCoords[i]);
    }
    return mesh;
}

MeshData axes(double halfLength) {
    if (!(halfLength > 0 && halfLength <= largestSize)) {
        throw Error("axes", "halfLength must be greater than 0 and at most 1e+38", numberText(halfLength));
    }
    MeshData mesh;
    mesh.primitive = Primitive::lines;
    for (int axis = 0; axis < 3; ++axis) {
        for (const int sign : {-1, 1}) {
            fvec3 end(0);
            end[axis] = static_cast<float>(sign * halfLength);
            fvec4 color(0, 0, 0, 1);
            color[axis] = 1;
            mesh.positions.push_back(end);
            mesh.colors.push_back(color);
        }
    }
    return mesh;
}

MeshData ringStrip(double inner, double outer, int segments) {
    if (!(inner >= 0)) throw Error("ringStrip", "inner must be at least 0", numberText(inner));
    if (!(outer > inner && outer <= largestSize)) {
        throw Error("ringStrip", "outer must be greater than inner and at most 1e+38",
                    "inner " + numberText(inner) + ", outer " + numberText(outer));
    }
    requireRange("ringStrip", "segments", segments, 3, mostDivisions);
    MeshData mesh;
    mesh.primitive = Primitive::triangleStrip;
    for (int i = 0; i <= segments; ++i) {
        const vec2 direction = onCircle(i, segments);
        for (const double radius : {outer, inner}) mesh.positions.emplace_back(vec3(radius * direction, 0));
    }
    return mesh;
}

MeshData box(const vec3& lo, const vec3& hi) {
    requireFinite("box", "lo", lo);
    requireFinite("box", "hi", hi);
    for (int i = 0; i < 3; ++i) {
        if (std::abs(lo[i]) > largestSize || std::abs(hi[i]) > largestSize) {
            throw Error("box", "lo and hi must lie within 1e+38", vectorText(lo) + " and " + vectorText(hi));
        }
        if (static_cast<float>(lo[i]) < static_cast<float>(hi[i])) continue;
        throw Error("box", "lo must be below hi in each coordinate, as floats",
                    vectorText(lo) + " and " + vectorText(hi));
    }
    MeshData mesh;
    for (const BoxSide& face : boxSides) {
        for (const std::size_t i : quadOrder) {
            const fvec3 corner = cornerOf(face.corners[i]);
            fvec3 position;
            fvec2 texCoord(0.5f);
            for (int axis = 0; axis < 3; ++axis) {
                position[axis] = static_cast<float>(corner[axis] < 0 ? lo[axis] : hi[axis]);
                texCoord += 0.5f * corner[axis] * fvec2(face.right[axis], face.up[axis]);
            }
            mesh.positions.push_back(position);
            mesh.normals.push_back(face.normal);
            mesh.texCoords.push_back(texCoord);
        }
    }
    return mesh;
}

MeshData sphere(double radius, int slices, int stacks) {
    requireSize("sphere", "radius", radius, 1e-37);
    requireRange("sphere", "slices", slices, 3, mostDivisions);
    requireRange("sphere", "stacks", stacks, 2, mostDivisions);
    MeshData mesh;

    // Rows from the south pole to the north pole. A pole has a vertex for each slice, in the middle of it, so that
    // the picture is not sheared there; the other rows have one more than slices, the first again with u = 1.
    for (int row = 0; row <= stacks; ++row) {
        const bool pole = row == 0 || row == stacks;
        const double latitude = pi * row / stacks;
        const double ringRadius = std::sin(latitude);
        const double height = -std::cos(latitude);
        for (int i = 0; i < (pole ? slices : slices + 1); ++i) {
            const vec2 direction = onCircle(i, slices);
            // A pole is written out: 0 * direction would leave -0 in some of its vertices.
            const vec3 normal =
                pole ? vec3(0, height, 0) : vec3(ringRadius * direction.x, height, -ringRadius * direction.y);
            mesh.positions.emplace_back(radius * normal);
            mesh.normals.emplace_back(normal);
            mesh.texCoords.emplace_back(vec2((pole ? i + 0.5 : i) / slices, static_cast<double>(row) / stacks));
        }
    }

    const auto rowAt = [slices, stacks](int row) {
        const int first = row == 0 ? 0 : slices + (row - 1) * (slices + 1);
        return Row{static_cast<std::uint32_t>(first), row == 0 || row == stacks};
    };
    for (int row = 0; row < stacks; ++row) joinRows(mesh, rowAt(row), rowAt(row + 1), slices);
    return mesh;
}

MeshData torus(double major, double minor, int slices, int stacks) {
    requireSize("torus", "minor", minor, 1e-37);
    requireSize("torus", "major", major, minor);
    // Beside a large ring a thin tube is rounded away, and beside a thick tube a small hole.
    if (!(static_cast<float>(major - minor) > 0 && static_cast<float>(major + minor) > static_cast<float>(major))) {
        throw Error("torus", "minor must be below major, and both it and the hole large enough to be told as floats",
                    "major " + numberText(major) + ", minor " + numberText(minor));
    }
    requireRange("torus", "slices", slices, 3, mostDivisions);
    requireRange("torus", "stacks", stacks, 3, mostDivisions);
    MeshData mesh;
    for (int row = 0; row <= stacks; ++row) {
        const vec2 around = onCircle(row, stacks);
        for (int i = 0; i <= slices; ++i) {
            const vec2 direction = onCircle(i, slices);
            const double radius = major + minor * around.x;
            mesh.positions.emplace_back(vec3(radius * direction.x, minor * around.y, -radius * direction.y));
            mesh.normals.emplace_back(vec3(around.x * direction.x, around.y, -around.x * direction.y));
            mesh.texCoords.emplace_back(vec2(static_cast<double>(i) / slices, static_cast<double>(row) / stacks));
        }
    }
    const auto rowAt = [slices](int row) { return Row{static_cast<std::uint32_t>(row * (slices + 1)), false}; };
    for (int row = 0; row < stacks; ++row) joinRows(mesh, rowAt(row), rowAt(row + 1), slices);
    return mesh;
}

namespace {

void requireProfile(std::span<const vec2> profile) {
    if (profile.size() < 3) {
        throw Error("lathe", "the profile must have at least 3 points", std::to_string(profile.size()));
    }
    double doubleArea = 0;
    for (std::size_t i = 0; i < profile.size(); ++i) {
        const vec2 point = profile[i];
        const bool end = i == 0 || i + 1 == profile.size();
        const std::string name = "point " + std::to_string(i) + " of the profile";
        requireFinite("lathe", name, point);
        if (end && point.x != 0) throw Error("lathe", name + ", an end, must lie on the axis", vectorText(point));
        if (!end) requireSize("lathe", "the radius of " + name, point.x, 1e-37);
        if (std::abs(point.y) > largestSize) throw Error("lathe", name + " must lie within 1e+38", vectorText(point));
        if (i == 0) continue;
        if (fvec2(point) == fvec2(profile[i - 1])) {
            throw Error("lathe", name + " must differ from the one before, as floats", vectorText(point));
        }
        doubleArea += (profile[i - 1] + point).x / largestSize * ((point - profile[i - 1]).y / largestSize);
    }
    if (!(doubleArea > 0)) throw Error("lathe", "the profile must have the outside on its right");
}

// Across a piece of the profile, to its right, of unit length.
vec2 rightOf(const vec2& from, const vec2& to) {
    const vec3 along = unit(vec3(to - from, 0));
    return {along.y, -along.x};
}

// The normals of a profile point, for the piece below it and the one above; the same where it is smooth.
std::array<vec2, 2> profileNormals(const vec2& below, const vec2& above, double crease) {
    const double turn = degrees(std::atan2(std::abs(below.x * above.y - below.y * above.x), glm::dot(below, above)));
    if (turn > crease) return {below, above};
    const vec2 smooth(unit(vec3(below + above, 0)));
    return {smooth, smooth};
}

}  // namespace

MeshData lathe(std::span<const vec2> profile, int slices, double crease) {
    requireProfile(profile);
    requireRange("lathe", "slices", slices, 3, mostDivisions);
    if (!(crease >= 0 && crease <= 180)) throw Error("lathe", "crease must be 0 to 180 degrees", numberText(crease));
    MeshData mesh;
    const auto addRow = [&](const vec2& point, const vec2& normal, double v) {
        const Row row{static_cast<std::uint32_t>(mesh.positions.size()), point.x == 0};
        for (int i = 0; i < (row.pole ? slices : slices + 1); ++i) {
            // A pole's vertex, and its normal where it is not smooth, belong to the middle of a slice.
            const vec2 direction = row.pole ? onCircle(2 * i + 1, 2 * slices) : onCircle(i, slices);
            const vec2 flat = point.x * direction;
            mesh.positions.emplace_back(row.pole ? vec3(0, point.y, 0) : vec3(flat.x, point.y, -flat.y));
            mesh.normals.emplace_back(vec3(normal.x * direction.x, normal.y, -normal.x * direction.y));
            mesh.texCoords.emplace_back(vec2((row.pole ? i + 0.5 : i) / slices, v));
        }
        return row;
    };

    std::vector<double> lengths{0};  // of the profile, up to each point
    for (std::size_t i = 1; i < profile.size(); ++i) {
        lengths.push_back(lengths.back() +
                          std::hypot(profile[i].x - profile[i - 1].x, profile[i].y - profile[i - 1].y));
    }
    // Piece by piece upwards. At an end the profile goes on as its own mirror image, on the other side of the axis.
    vec2 below = rightOf(profile[0], profile[1]);
    Row lower = addRow(profile[0], profileNormals({-below.x, below.y}, below, crease)[1], 0);
    for (std::size_t i = 1; i < profile.size(); ++i) {
        const bool end = i + 1 == profile.size();
        const vec2 above = end ? vec2(-below.x, below.y) : rightOf(profile[i], profile[i + 1]);
        const auto normals = profileNormals(below, above, crease);
        const double v = lengths[i] / lengths.back();
        const Row upper = addRow(profile[i], normals[0], v);
        joinRows(mesh, lower, upper, slices);
        if (!end) lower = normals[0] == normals[1] ? upper : addRow(profile[i], normals[1], v);
        below = above;
    }
    return mesh;
}

MeshData grid(int cellsX, int cellsZ, double sizeX, double sizeZ) {
    requireRange("grid", "cellsX", cellsX, 1, mostDivisions);
    requireRange("grid", "cellsZ", cellsZ, 1, mostDivisions);
    requireSize("grid", "sizeX", sizeX, 1e-30);
    requireSize("grid", "sizeZ", sizeZ, 1e-30);
    MeshData mesh;
    for (int row = 0; row <= cellsZ; ++row) {
        for (int i = 0; i <= cellsX; ++i) {
            const vec2 at(static_cast<double>(i) / cellsX, static_cast<double>(row) / cellsZ);
            mesh.positions.emplace_back(vec3((at.x - 0.5) * sizeX, 0, (0.5 - at.y) * sizeZ));
            mesh.normals.emplace_back(0, 1, 0);
            mesh.texCoords.emplace_back(at);
        }
    }
    for (int row = 0; row < cellsZ; ++row) {
        for (int i = 0; i < cellsX; ++i) {
            const auto near = static_cast<std::uint32_t>(row * (cellsX + 1) + i);
            const std::uint32_t far = near + static_cast<std::uint32_t>(cellsX + 1);
            mesh.indices.insert(mesh.indices.end(), {near, near + 1, far + 1, near, far + 1, far});
        }
    }
    return mesh;
}

}  // namespace mv
