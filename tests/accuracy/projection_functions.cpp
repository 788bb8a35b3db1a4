// projection.h and unproject.h.
#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

#include "accuracy/function.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"
#include "mv/math/unproject.h"

namespace mv::accuracy {
namespace {

using test::wide;
using test::Wide3;
using test::Wide4;
using test::WideMatrix;

WideMatrix zero() { return wide(mat4(0)); }

// Two bounds that differ by 1e-12 to 10 of their size.
void putBounds(Random& random, Domain domain, double scale, Arguments& a, std::size_t i) {
    if (domain == Domain::ordinary) {
        a[i] = random.number(-80, -10);
        a[i + 1] = random.number(10, 80);
    } else {
        a[i] = scale * random.number(-1, 1);
        const double sign = random.sign();
        a[i + 1] = a[i] + scale * sign * random.logarithmic(1e-12, 10);
    }
}

// near and far from index i.
void putDepths(Random& random, Domain domain, Arguments& a, std::size_t i) {
    if (domain == Domain::ordinary) {
        a[i] = random.logarithmic(0.01, 1);
        a[i + 1] = random.logarithmic(10, 1000);
    } else {
        a[i] = random.logarithmic(1e-300, 1e290);
        a[i + 1] = a[i] * (1 + random.logarithmic(1e-12, 1e12));
    }
}

// fovy, aspect, near, far.
Arguments views(Random& random, Domain domain) {
    Arguments a{};
    if (domain == Domain::ordinary) {
        a[0] = random.number(10, 120);
        a[1] = random.number(0.5, 2);
    } else {
        const double fovy = random.logarithmic(1e-9, 90);
        a[0] = random.sign() < 0 ? fovy : 180 - fovy;
        a[1] = random.logarithmic(1e-9, 1e9);
    }
    putDepths(random, domain, a, 2);
    return a;
}

const std::string angleLimits = "fovy at least 1e-290";
bool hasFullAngle(const Arguments& a) { return a[0] >= 1e-290; }

struct HalfAngle {
    Wide tangent, cotangent;
};
HalfAngle halfAngle(double fovy) {
    const Wide half = test::wideRadians(fovy) / 2, s = sin(half), c = cos(half);
    return {s / c, c / s};
}

Truth frustumTruth(const Arguments& a) {
    const Wide l = a[0], r = a[1], b = a[2], t = a[3], n = a[4], f = a[5];
    WideMatrix m = zero();
    m.column[0][0] = 2 * n / (r - l);
    m.column[1][1] = 2 * n / (t - b);
    m.column[2] = {{(r + l) / (r - l), (t + b) / (t - b), -(f + n) / (f - n), Wide(-1)}};
    m.column[3][2] = -2 * f * n / (f - n);
    return entrywise(valuesOf(m));
}

// A camera's clipFromWorld; far/near up to 1e3 or 1e8.
Arguments cameraMatrices(Random& random, Domain domain, double mostRatio) {
    const double ratio = random.logarithmic(10, domain == Domain::whole ? mostRatio : 1e3);
    const double near = domain == Domain::whole ? random.logarithmic(1e-3, 1e3) : random.logarithmic(0.1, 1);
    const double fovy = random.number(10, 120), aspect = random.number(0.5, 2);
    const vec3 eye = near * random.point(10), at = near * random.point(10);
    Arguments a{};
    put(a, 0, perspective(fovy, aspect, near, near * ratio) * lookAtAnyRoll(eye, at));
    return a;
}

Truth planesTruth(const Arguments& a) {
    const WideMatrix m = wide(matrixAt(a, 0));
    const auto row = [&](std::size_t i) {
        return Wide4{{m.column[0][i], m.column[1][i], m.column[2][i], m.column[3][i]}};
    };
    Truth truth;
    for (std::size_t i = 0; i < 6; ++i) {
        Wide4 plane = i % 2 == 0 ? row(3) + row(i / 2) : row(3) - row(i / 2);
        const Wide size = length(firstThree(plane));
        plane = size == 0 ? Wide4{{Wide(0), Wide(0), Wide(0), Wide(1)}} : plane / size;  // at infinity
        truth.values.insert(truth.values.end(), plane.element.begin(), plane.element.end());
        truth.blocks.insert(truth.blocks.end(), {3, 1});
        truth.sizes.push_back(std::max<Wide>({abs(plane[0]), abs(plane[1]), abs(plane[2]), leastSize}));
        truth.sizes.push_back(sizeOf(plane[3]));
    }
    return truth;
}

// The columns of the inverse, by elimination with pivots.
WideMatrix inverse(WideMatrix m) {
    WideMatrix result = wide(mat4(1));
    for (std::size_t k = 0; k < 4; ++k) {
        std::size_t pivot = k;
        for (std::size_t row = k; row < 4; ++row) {
            if (abs(m.column[k][row]) > abs(m.column[k][pivot])) pivot = row;
        }
        for (std::size_t column = 0; column < 4; ++column) {
            std::swap(m.column[column][k], m.column[column][pivot]);
            std::swap(result.column[column][k], result.column[column][pivot]);
        }
        for (std::size_t row = 0; row < 4; ++row) {
            const Wide factor = row == k ? 1 - 1 / m.column[k][k] : m.column[k][row] / m.column[k][k];
            for (std::size_t column = 0; column < 4; ++column) {
                const Wide ofPivot = m.column[column][k], ofResult = result.column[column][k];
                m.column[column][row] -= factor * ofPivot;
                result.column[column][row] -= factor * ofResult;
            }
        }
    }
    return result;
}

// |m| |v|, entry by entry.
Wide4 timesWithoutSigns(const WideMatrix& m, const Wide4& v) {
    Wide4 sum{};
    for (std::size_t row = 0; row < 4; ++row) {
        for (std::size_t column = 0; column < 4; ++column) sum[row] += abs(m.column[column][row] * v[column]);
    }
    return sum;
}

Truth cornersTruth(const Arguments& a) {
    const WideMatrix clipFromWorld = wide(matrixAt(a, 0)), worldFromClip = inverse(clipFromWorld);
    Truth truth;
    for (unsigned i = 0; i < 8; ++i) {
        const vec4 cube((i & 1U) ? 1 : -1, (i & 2U) ? 1 : -1, (i & 4U) ? 1 : -1, 1);
        const Wide4 world = worldFromClip * wide(cube);
        const Wide3 corner = divided(world);
        // The move of the corner by a change of each entry of the matrix by one part, in such parts.
        const Wide4 moved = timesWithoutSigns(worldFromClip, timesWithoutSigns(clipFromWorld, world));
        Wide size = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            size = std::max<Wide>(size, (moved[k] + abs(corner[k]) * moved[3]) / abs(world[3]));
        }
        // Where some roundings of the matrix are w itself, it has no corner to be off from.
        if (moved[3] > ldexp(abs(world[3]), 53 - 6)) size = anySize;
        truth.values.insert(truth.values.end(), corner.element.begin(), corner.element.end());
        truth.blocks.push_back(3);
        truth.sizes.push_back(size);
    }
    return truth;
}

// ---- unproject.h: matrix, pixel, depth, width and height

Arguments pixelsOfCameras(Random& random, Domain domain) {
    Arguments a = cameraMatrices(random, domain, 1e6);
    for (std::size_t i = 0; i < 2; ++i) {
        a[19 + i] = std::floor(random.logarithmic(1, 16385));
        a[16 + i] = a[19 + i] * random.number(0, 1);
    }
    const double depth = domain == Domain::whole ? random.logarithmic(1e-9, 1) : random.number(0, 1);
    a[18] = random.sign() < 0 ? depth : 1 - depth;
    return a;
}
const std::string pixelLimits =
    "entries of the matrix, and coordinates, 0 or from 1e-10 to 1e10 in size; pictures 1 to 16384 pixels wide and high";
bool arePixels(const Arguments& a) {
    static const auto areEntries = sizesBetween(1e-10, 1e10);
    return areEntries(a) && isPictureSize(a[19]) && isPictureSize(a[20]);
}
Wide ndcOf(const Arguments& a, std::size_t axis) { return 2 * Wide(a[16 + axis]) / a[19 + axis] - 1; }

Truth unProjectTruth(const Arguments& a) {
    const WideMatrix clipFromWorld = wide(matrixAt(a, 0)), worldFromClip = inverse(clipFromWorld);
    const Wide4 clip{{ndcOf(a, 0), ndcOf(a, 1), 2 * Wide(a[18]) - 1, Wide(1)}}, world = worldFromClip * clip;
    const Wide3 point = divided(world);
    Wide4 terms = timesWithoutSigns(clipFromWorld, world);
    for (std::size_t i = 0; i < 4; ++i) terms[i] += abs(clip[i]);
    const Wide4 moved = timesWithoutSigns(worldFromClip, terms);
    Wide size = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        size = std::max<Wide>(size, (moved[k] + abs(point[k]) * moved[3]) / abs(world[3]));
    }
    if (moved[3] > ldexp(abs(world[3]), 53 - 6)) size = anySize;
    return {{point[0], point[1], point[2]}, {3}, {}, false, {size}};
}

Truth directionTruth(const Arguments& a) {
    const WideMatrix m = wide(matrixAt(a, 0));
    const auto entry = [&](std::size_t row, std::size_t column) { return m.column[column][row]; };
    std::array<Wide3, 2> planes, terms;
    for (std::size_t i = 0; i < 2; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            const Wide times = ndcOf(a, i) * entry(3, k);
            planes[i][k] = entry(i, k) - times;
            terms[i][k] = abs(entry(i, k)) + abs(times);
        }
    }
    const Wide3 along = cross(planes[0], planes[1]);
    const Wide long2 = length(along);
    Wide forward = 0, size = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t l = (k + 1) % 3, n = (k + 2) % 3;
        forward += along[k] * entry(3, k);
        size = std::max<Wide>(size, terms[0][l] * abs(planes[1][n]) + abs(planes[0][l]) * terms[1][n] +
                                        terms[0][n] * abs(planes[1][l]) + abs(planes[0][n]) * terms[1][l]);
    }
    const Wide3 unit = (forward < 0 ? Wide(-1) : Wide(1)) / long2 * along;
    // Turned over by a rounding: a matrix that is nearly none of a camera
    const Wide depthwards = length(Wide3{{entry(3, 0), entry(3, 1), entry(3, 2)}});
    const bool isOpen = abs(forward) < Wide(1e-9) * long2 * depthwards || size > ldexp(long2, 40);
    return {{unit[0], unit[1], unit[2]}, {3}, {}, false, {isOpen ? anySize : Wide(1 + size / long2)}};
}

}  // namespace

std::vector<Function> projectionFunctions() {
    std::vector<Function> list;
    list.push_back(withForms(
        {.name = "ortho",
         .header = "projection.h",
         .returns = "the projection of a box",
         .measured = "entrywise",
         .domain = "bounds 1e-150 to 1e150, 1e-12 to 10 of their size apart",
         .reason = "",
         .sample =
             [](Random& random, Domain domain) {
                 const double scale = anyScale(random, domain, 140);
                 Arguments a{};
                 for (const std::size_t i : {0u, 2u, 4u}) putBounds(random, domain, scale, a, i);
                 return a;
             },
         .truth =
             [](const Arguments& a) {
                 WideMatrix m = zero();
                 for (std::size_t i = 0; i < 3; ++i) {
                     const Wide low = a[2 * i], high = a[2 * i + 1];
                     m.column[i][i] = (i == 2 ? -2 : 2) / (high - low);
                     m.column[3][i] = -(low + high) / (high - low);
                 }
                 m.column[3][3] = 1;
                 return entrywise(valuesOf(m));
             }},
        [](const Arguments& a) { return ortho(a[0], a[1], a[2], a[3], a[4], a[5]); },
        []<typename T>(const ArgumentsOf<T>& a) { return glm::orthoRH_NO(a[0], a[1], a[2], a[3], a[4], a[5]); }));
    list.push_back(withForms(
        {.name = "perspective",
         .header = "projection.h",
         .returns = "a symmetric perspective",
         .measured = "entrywise",
         .domain = "fovy 1e-9 to 180 − 1e-9 degrees, near 1e-300 to 1e290, far/near − 1 from 1e-12 to 1e12",
         .bound = 6,
         .reason = "roundings: 2.4 of the angle, in which 45° magnifies those of the radians 1.57 times, a tangent, "
                   "and two or three quotients",
         .sample = views,
         .truth =
             [](const Arguments& a) {
                 const Wide f = halfAngle(a[0]).cotangent, near = a[2], far = a[3];
                 WideMatrix m = zero();
                 m.column[0][0] = f / a[1];
                 m.column[1][1] = f;
                 m.column[2][2] = -(far + near) / (far - near);
                 m.column[2][3] = -1;
                 m.column[3][2] = -2 * far * near / (far - near);
                 return entrywise(valuesOf(m));
             },
         .limits = angleLimits,
         .within = hasFullAngle},
        [](const Arguments& a) { return perspective(a[0], a[1], a[2], a[3]); },
        []<typename T>(const ArgumentsOf<T>& a) {
            return glm::perspectiveRH_NO(glm::radians(a[0]), a[1], a[2], a[3]);
        }));
    list.push_back(withForms(
        {.name = "infinitePerspective",
         .header = "projection.h",
         .returns = "a perspective without a far plane",
         .measured = "entrywise",
         .domain = "fovy 1e-9 to 180 − 1e-9 degrees, near 1e-300 to 1e290",
         .bound = 6,
         .reason = "as perspective",
         .sample = views,
         .truth =
             [](const Arguments& a) {
                 const Wide f = halfAngle(a[0]).cotangent, near = a[2];
                 WideMatrix m = zero();
                 m.column[0][0] = f / a[1];
                 m.column[1][1] = f;
                 m.column[2][2] = m.column[2][3] = -1;
                 m.column[3][2] = -2 * near;
                 return entrywise(valuesOf(m));
             },
         .limits = angleLimits,
         .within = hasFullAngle},
        [](const Arguments& a) { return infinitePerspective(a[0], a[1], a[2]); },
        []<typename T>(const ArgumentsOf<T>& a) { return glm::infinitePerspective(glm::radians(a[0]), a[1], a[2]); }));
    list.push_back(withForms(
        {.name = "frustum",
         .header = "projection.h",
         .returns = "a perspective through any window",
         .measured = "entrywise",
         .domain = "as perspective, window bounds 1e-12 to 10 of their size apart",
         .reason = "",
         .sample =
             [](Random& random, Domain domain) {
                 Arguments a{};
                 putDepths(random, domain, a, 4);
                 const double scale = a[4] * anyScale(random, domain, 6);
                 for (const std::size_t i : {0u, 2u}) putBounds(random, domain, scale, a, i);
                 return a;
             },
         .truth = frustumTruth},
        [](const Arguments& a) { return frustum(a[0], a[1], a[2], a[3], a[4], a[5]); },
        []<typename T>(const ArgumentsOf<T>& a) { return glm::frustumRH_NO(a[0], a[1], a[2], a[3], a[4], a[5]); }));
    list.push_back(withForms({.name = "frustumBounds",
                              .header = "projection.h",
                              .returns = "the window of a perspective",
                              .measured = "entrywise",
                              .domain = "as perspective",
                              .bound = 7,
                              .reason = "roundings: those of the tangent as in perspective, and three products",
                              .sample = views,
                              .truth =
                                  [](const Arguments& a) {
                                      const Wide top = a[2] * halfAngle(a[0]).tangent, right = top * a[1];
                                      return entrywise({-right, right, -top, top, a[2], a[3]});
                                  },
                              .limits = angleLimits,
                              .within = hasFullAngle},
                             [](const Arguments& a) { return frustumBounds(a[0], a[1], a[2], a[3]); }));
    list.push_back(
        withForms({.name = "planesFromClip",
                   .header = "projection.h",
                   .returns = "the six planes of a matrix's view",
                   .measured = "ulp of each normal's largest entry, and of each distance",
                   .domain = "cameras with near 1e-3 to 1e3 and far/near 10 to 1e8",
                   .bound = 6,
                   .reason = "roundings: a sum, a length 3.5 and a quotient",
                   .sample = [](Random& random, Domain domain) { return cameraMatrices(random, domain, 1e8); },
                   .truth = planesTruth},
                  [](const Arguments& a) { return planesFromClip(matrixAt(a, 0)); }));
    list.push_back(withForms(
        {.name = "perspectivePlanes",
         .header = "projection.h",
         .returns = "the six planes of perspective's arguments",
         .measured = "entrywise",
         .domain = "as perspective",
         .bound = 7,
         .reason = "roundings: those of the tangent as in perspective, two quotients, a length and one quotient more",
         .sample = views,
         .truth =
             [](const Arguments& a) {
                 const Wide tangent = halfAngle(a[0]).tangent;
                 const auto inward = [](const Wide& t) {
                     const Wide length = sqrt(1 + t * t);
                     return std::array<Wide, 2>{1 / length, -t / length};
                 };
                 const auto side = inward(tangent * a[1]), level = inward(tangent);
                 return entrywise({side[0], 0,        side[1],  0,           -side[0], 0,         side[1],  0,
                                   0,       level[0], level[1], 0,           0,        -level[0], level[1], 0,
                                   0,       0,        -1,       -Wide(a[2]), 0,        0,         1,        a[3]});
             },
         .limits = angleLimits,
         .within = hasFullAngle},
        [](const Arguments& a) { return perspectivePlanes(a[0], a[1], a[2], a[3]); }));
    list.push_back(
        withForms({.name = "viewVolumeCorners",
                   .header = "projection.h",
                   .returns = "the eight corners of a view",
                   .measured = "ulp of what one rounding of each entry of the matrix moves the corner by",
                   .domain = "cameras with near 1e-3 to 1e3 and far/near 10 to 1e6",
                   .reason = "",
                   .sample = [](Random& random, Domain domain) { return cameraMatrices(random, domain, 1e6); },
                   .truth = cornersTruth,
                   .limits = "entries 0, or from 1e-10 to 1e10 in size",
                   .within = sizesBetween(1e-10, 1e10)},
                  [](const Arguments& a) { return viewVolumeCorners(matrixAt(a, 0)); }));
    list.push_back(withForms({.name = "ndcFromClip",
                              .header = "projection.h",
                              .returns = "clip coordinates divided by w",
                              .measured = "entrywise",
                              .domain = "1e-150 to 1e150",
                              .bound = 0.5,
                              .reason = "",
                              .sample =
                                  [](Random& random, Domain domain) {
                                      Arguments a{};
                                      for (std::size_t i = 0; i < 3; ++i) a[i] = anyNumber(random, domain);
                                      a[3] = std::abs(anyNumber(random, domain));
                                      return a;
                                  },
                              .truth =
                                  [](const Arguments& a) {
                                      const Wide3 ndc = divided(wide(pointAt(a, 0)));
                                      return entrywise({ndc[0], ndc[1], ndc[2]});
                                  }},
                             [](const Arguments& a) { return ndcFromClip(pointAt(a, 0)); }));
    list.push_back(withForms({.name = "pixelFromNdc",
                              .header = "projection.h",
                              .returns = "where in a viewport a point falls",
                              .measured = "entrywise",
                              .domain = "1e-12 to 1e3, and as close to −1; pictures 1 to 16384 pixels wide",
                              .reason = "",
                              .sample =
                                  [](Random& random, Domain domain) {
                                      Arguments a{};
                                      for (std::size_t i = 0; i < 2; ++i) {
                                          const double sign = domain == Domain::ordinary ? 1 : random.sign();
                                          a[i] = domain == Domain::ordinary ? random.number(-1, 1)
                                                                            : sign * random.logarithmic(1e-12, 1e3);
                                          if (domain == Domain::whole && random.sign() < 0) a[i] -= 1;
                                          a[i + 2] = std::floor(random.logarithmic(1, 16385));
                                      }
                                      return a;
                                  },
                              .truth =
                                  [](const Arguments& a) {
                                      return entrywise({(Wide(a[0]) + 1) / 2 * a[2], (Wide(a[1]) + 1) / 2 * a[3]});
                                  },
                              .limits = "pictures 1 to 16384 pixels wide and high",
                              .within = [](const Arguments& a) { return isPictureSize(a[2]) && isPictureSize(a[3]); }},
                             [](const Arguments& a) {
                                 return pixelFromNdc(vec2(a[0], a[1]), static_cast<int>(a[2]), static_cast<int>(a[3]));
                             }));
    const auto pixelOf = [](const Arguments& a) { return vec2(a[16], a[17]); };
    const auto sizeOfPicture = [](const Arguments& a, std::size_t i) { return static_cast<int>(a[19 + i]); };
    const std::string camerasDomain = "cameras with near 1e-3 to 1e3 and far/near 10 to 1e6, depths 1e-9 from 0 and 1";
    list.push_back(
        withForms({.name = "unProject",
                   .header = "unproject.h",
                   .returns = "the point that is drawn at a pixel with a depth",
                   .measured = "ulp of what one rounding of each entry of the matrix, and of pixel and depth, "
                               "moves the point by",
                   .domain = camerasDomain,
                   .reason = "",
                   .sample = pixelsOfCameras,
                   .truth = unProjectTruth,
                   .limits = pixelLimits,
                   .within = arePixels},
                  [=](const Arguments& a) {
                      return unProject(pixelOf(a), a[18], matrixAt(a, 0), sizeOfPicture(a, 0), sizeOfPicture(a, 1));
                  }));
    list.push_back(withForms(
        {.name = "directionThroughPixel",
         .header = "unproject.h",
         .returns = "the direction of a pixel's ray",
         .measured = "ulp of what one rounding of each entry and of the pixel turns it by, and of 1",
         .domain = camerasDomain,
         .reason = "",
         .sample = pixelsOfCameras,
         .truth = directionTruth,
         .limits = pixelLimits,
         .within = arePixels},
        [=](const Arguments& a) {
            return directionThroughPixel(pixelOf(a), matrixAt(a, 0), sizeOfPicture(a, 0), sizeOfPicture(a, 1));
        }));
    return list;
}

}  // namespace mv::accuracy
