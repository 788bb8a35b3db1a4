// types.h and transform.h.
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

#include "accuracy/function.h"
#include "mv/math/transform.h"

namespace mv::accuracy {
namespace {

using test::wide;
using test::Wide3;
using test::WideMatrix;

WideMatrix identity() { return wide(mat4(1)); }

// A direction whose entries differ in size as well.
vec3 anyVector(Random& random, Domain domain, double size) {
    if (domain == Domain::ordinary) {
        const double length = random.number(0.1, 10);
        return length * random.direction();
    }
    const double scale = anyScale(random, domain, size);
    const vec3 factors{random.logarithmic(1e-9, 1), random.logarithmic(1e-9, 1), random.logarithmic(1e-9, 1)};
    return scale * factors * random.direction();
}

double anyAngle(Random& random, Domain domain) {
    return domain == Domain::ordinary ? random.number(-360, 360) : anyNumber(random, domain, 300);
}

WideMatrix rotation(double degrees, const Wide3& axis) {
    const Wide angle = reducedRadians(degrees), s = sin(angle), c = cos(angle);
    const Wide3 v = normalized(axis);
    WideMatrix m = identity();
    for (std::size_t column = 0; column < 3; ++column) {
        for (std::size_t row = 0; row < 3; ++row) {
            m.column[column][row] = v[row] * v[column] * (1 - c) + (row == column ? c : Wide(0));
        }
    }
    m.column[0][1] += v[2] * s;
    m.column[1][0] -= v[2] * s;
    m.column[2][0] += v[1] * s;
    m.column[0][2] -= v[1] * s;
    m.column[1][2] += v[0] * s;
    m.column[2][1] -= v[0] * s;
    return m;
}

Function aboutAxis(const std::string& name, const vec3& axis, mat4 (*ours)(double)) {
    return withForms(
        {.name = name,
         .header = "transform.h",
         .returns = "turns about the " + name.substr(6) + " axis",
         .measured = "ulp of 1",
         .domain = "angles 1e-300 to 1e300 degrees",
         .reason = "",
         .sample = [](Random& random, Domain domain) { return Arguments{anyAngle(random, domain)}; },
         .truth = [axis](const Arguments& a) { return oneBlock(valuesOf(rotation(a[0], wide(axis)))); }},
        [ours](const Arguments& a) { return ours(a[0]); },
        [axis]<typename T>(const ArgumentsOf<T>& a) {
            return glm::rotate(glm::mat<4, 4, T>(1), glm::radians(a[0]), glm::vec<3, T>(axis));
        });
}

Truth cameraTruth(const vec3& eye, const vec3& at, const Wide3& up) {
    const Wide3 forward = normalized(wide(at) - wide(eye)), right = normalized(cross(forward, up));
    const Wide3 top = cross(right, forward);
    WideMatrix m = identity();
    for (std::size_t k = 0; k < 3; ++k) {
        m.column[k][0] = right[k];
        m.column[k][1] = top[k];
        m.column[k][2] = -forward[k];
    }
    m.column[3] = {{-dot(right, wide(eye)), -dot(top, wide(eye)), dot(forward, wide(eye)), Wide(1)}};
    return {valuesOf(m), {12, 3, 1}};
}

// eye, at, up: up any angle off the view that is accepted, eye any number of distances away from the origin.
Arguments cameras(Random& random, Domain domain) {
    Arguments a{};
    if (domain == Domain::ordinary) {
        for (;;) {
            const vec3 eye = random.point(10), at = random.point(10), up = random.direction();
            if (glm::length(glm::cross(glm::normalize(at - eye), up)) < 0.1) continue;
            put(a, 0, eye);
            put(a, 3, at);
            put(a, 6, up);
            return a;
        }
    }
    const double scale = anyScale(random, domain, 290);
    const double away = random.logarithmic(1e-6, 1);
    const vec3 eye = scale * away * random.point(1);
    const double far = random.logarithmic(1e-6, 1);
    const vec3 at = eye + scale * far * random.direction();
    const vec3 view = glm::normalize((at - eye) / scale);
    const vec3 aside = glm::normalize(glm::cross(view, random.direction()));
    put(a, 0, eye);
    put(a, 3, at);
    const double upScale = anyScale(random, domain, 150), sign = random.sign();
    put(a, 6, upScale * (sign * view + random.logarithmic(2e-12, 10) * aside));
    return a;
}

// Columns nearly parallel, and of different sizes.
Arguments models(Random& random, Domain domain) {
    mat4 m(1);
    const vec3 first = random.direction();
    for (int column = 0; column < 3; ++column) {
        if (domain == Domain::ordinary) {
            // Like a rotation and a scale: no two columns within 30 degrees, sizes a hundredfold apart at most.
            vec3 v = random.direction();
            for (int k = 0; k < column; ++k) {
                while (std::abs(glm::dot(v, glm::normalize(vec3(m[k])))) > 0.86) {
                    v = random.direction();
                    k = 0;
                }
            }
            m[column] = vec4(random.logarithmic(0.1, 10) * v, 0);
        } else {
            const double apart = random.logarithmic(1e-8, 10);
            const vec3 v = first + apart * random.direction();
            m[column] = vec4(random.logarithmic(1e-3, 1e3) * v, 0);
        }
    }
    const double scale = anyScale(random, domain, 140);
    for (int column = 0; column < 3; ++column) m[column] *= scale;
    Arguments a{};
    put(a, 0, m);
    return a;
}

Truth normalTruth(const Arguments& a) {
    const Wide3 x = wide(vectorAt(a, 0)), y = wide(vectorAt(a, 4)), z = wide(vectorAt(a, 8));
    const Wide sign = dot(cross(y, z), x) < 0 ? -1 : 1;
    std::vector<Wide> values;
    for (const Wide3& column : {sign * cross(y, z), sign * cross(z, x), sign * cross(x, y)}) {
        values.insert(values.end(), column.element.begin(), column.element.end());
    }
    return {values, {3, 3, 3}, {}, true};
}

// As normalMatrix asks for. A column of the result that vanishes beside the others has no digits to compare.
bool haveUsualProportions(const Arguments& a) {
    Wide least = 1, most = 0;
    for (const std::size_t column : {0U, 4U, 8U}) {
        const double largest = std::max({std::abs(a[column]), std::abs(a[column + 1]), std::abs(a[column + 2])});
        for (std::size_t i = column; i < column + 3; ++i) {
            if (a[i] != 0 && std::abs(a[i]) < 1e-70 * largest) return false;
        }
    }
    const Wide3 x = wide(vectorAt(a, 0)), y = wide(vectorAt(a, 4)), z = wide(vectorAt(a, 8));
    bool isFirst = true;
    for (const Wide3& normal : {cross(y, z), cross(z, x), cross(x, y)}) {
        const Wide size = length(normal);
        if (size == 0) continue;
        least = isFirst ? size : std::min<Wide>(least, size);
        most = isFirst ? size : std::max<Wide>(most, size);
        isFirst = false;
    }
    return most * Wide(1e-290) <= least;
}

}  // namespace

std::vector<Function> typesFunctions() {
    const auto sample = [](Random& random, Domain domain) { return Arguments{anyNumber(random, domain, 300)}; };
    std::vector<Function> list;
    list.push_back(withForms(
        {.name = "radians",
         .header = "types.h",
         .returns = "degrees as radians",
         .measured = "entrywise",
         .domain = "1e-300 to 1e300",
         .reason = "",
         .sample = sample,
         .truth = [](const Arguments& a) { return entrywise({test::wideRadians(a[0])}); }},
        [](const Arguments& a) { return radians(a[0]); },
        []<typename T>(const ArgumentsOf<T>& a) { return glm::radians(a[0]); }));
    list.push_back(withForms(
        {.name = "degrees",
         .header = "types.h",
         .returns = "radians as degrees",
         .measured = "entrywise",
         .domain = "1e-300 to 1e300",
         .reason = "",
         .sample = sample,
         .truth = [](const Arguments& a) { return entrywise({a[0] * 180 / test::widePi()}); },
         .limits = "up to 3e306, of which the degrees are a number",
         .within = [](const Arguments& a) { return std::abs(a[0]) <= 3e306; }},
        [](const Arguments& a) { return degrees(a[0]); },
        []<typename T>(const ArgumentsOf<T>& a) { return glm::degrees(a[0]); }));
    return list;
}

std::vector<Function> transformFunctions() {
    const auto numbers = [](Random& random, Domain domain) {
        Arguments a{};
        for (std::size_t i = 0; i < 3; ++i) a[i] = anyNumber(random, domain, 300);
        return a;
    };
    std::vector<Function> list;
    list.push_back(withForms(
        {.name = "translate",
         .header = "transform.h",
         .returns = "moves points by an offset",
         .measured = "entrywise",
         .domain = "1e-300 to 1e300",
         .bound = 0,
         .reason = "",
         .sample = numbers,
         .truth =
             [](const Arguments& a) {
                 WideMatrix m = identity();
                 for (std::size_t i = 0; i < 3; ++i) m.column[3][i] = a[i];
                 return entrywise(valuesOf(m));
             }},
        [](const Arguments& a) { return translate(vectorAt(a, 0)); },
        []<typename T>(const ArgumentsOf<T>& a) { return glm::translate(glm::mat<4, 4, T>(1), vectorAt(a, 0)); }));
    list.push_back(withForms(
        {.name = "scale",
         .header = "transform.h",
         .returns = "multiplies x, y, z by factors",
         .measured = "entrywise",
         .domain = "1e-300 to 1e300",
         .bound = 0,
         .reason = "",
         .sample = numbers,
         .truth =
             [](const Arguments& a) {
                 WideMatrix m = identity();
                 for (std::size_t i = 0; i < 3; ++i) m.column[i][i] = a[i];
                 return entrywise(valuesOf(m));
             }},
        [](const Arguments& a) { return scale(vectorAt(a, 0)); },
        []<typename T>(const ArgumentsOf<T>& a) { return glm::scale(glm::mat<4, 4, T>(1), vectorAt(a, 0)); }));
    list.push_back(aboutAxis("rotateX", {1, 0, 0}, rotateX));
    list.push_back(aboutAxis("rotateY", {0, 1, 0}, rotateY));
    list.push_back(aboutAxis("rotateZ", {0, 0, 1}, rotateZ));
    list.push_back(withForms(
        {.name = "rotate",
         .header = "transform.h",
         .returns = "turns about an axis",
         .measured = "ulp of the largest entry",
         .domain = "angles 1e-300 to 1e300 degrees, axes 1e-150 to 1e150 long",
         .bound = 8,
         .reason =
             "as in MV.js the angle becomes radians first, with an error of up to 6e-16: 2.6; two components of 2.5 "
             "and the products of them add up to 5",
         .sample =
             [](Random& random, Domain domain) {
                 Arguments a{anyAngle(random, domain)};
                 put(a, 1, anyVector(random, domain, 150));
                 return a;
             },
         .truth = [](const Arguments& a) { return oneBlock(valuesOf(rotation(a[0], wide(vectorAt(a, 1))))); }},
        [](const Arguments& a) { return rotate(a[0], vectorAt(a, 1)); },
        []<typename T>(const ArgumentsOf<T>& a) {
            return glm::rotate(glm::mat<4, 4, T>(1), glm::radians(a[0]), vectorAt(a, 1));
        }));
    list.push_back(withForms(
        {.name = "lookAt",
         .header = "transform.h",
         .returns = "the view matrix of a camera, up given",
         .measured = "ulp of the largest entry, turn and offset apart",
         .domain = "distances 1e-296 to 1e290, up 2e-12 to 1.5 rad off the view",
         .bound = 50,
         .reason =
             "up 0.1 rad off the view magnifies the roundings of view and product, together 4.4 halves of an ulp, ten "
             "times",
         .sample = cameras,
         .truth = [](const Arguments& a) { return cameraTruth(vectorAt(a, 0), vectorAt(a, 3), wide(vectorAt(a, 6))); }},
        [](const Arguments& a) { return lookAt(vectorAt(a, 0), vectorAt(a, 3), vectorAt(a, 6)); },
        []<typename T>(const ArgumentsOf<T>& a) {
            return glm::lookAtRH(vectorAt(a, 0), vectorAt(a, 3), vectorAt(a, 6));
        }));
    list.push_back(withForms(
        {.name = "lookAtAnyRoll",
         .header = "transform.h",
         .returns = "the same, up chosen",
         .measured = "ulp of the largest entry, turn and offset apart",
         .domain = "as lookAt",
         .bound = 8,
         .reason = "roundings: 3.5 of a unit vector, of a cross product the same again, and its unit vector's",
         .sample = cameras,
         .truth =
             [](const Arguments& a) {
                 const vec3 view = glm::abs(vectorAt(a, 3) - vectorAt(a, 0));
                 const int axis = view.y <= view.z ? (view.y <= view.x ? 1 : 0) : (view.z <= view.x ? 2 : 0);
                 vec3 up(0);
                 up[axis] = 1;
                 return cameraTruth(vectorAt(a, 0), vectorAt(a, 3), wide(up));
             }},
        [](const Arguments& a) { return lookAtAnyRoll(vectorAt(a, 0), vectorAt(a, 3)); }));
    list.push_back(withForms(
        {.name = "normalMatrix",
         .header = "transform.h",
         .returns = "the matrix that takes normals where m takes points",
         .measured = "ulp of each column's largest entry, the matrix scaled to norm 1",
         .domain = "sizes 1e-140 to 1e140, columns 1e-8 to 10 apart and 1e6-fold longer",
         .bound = 45,
         .reason = "columns that span a tenth of their lengths' product still take the plain cross product, whose 2.4 "
                   "halves of an ulp are ten times as much there, and of the largest entry √3 times that",
         .sample = models,
         .truth = normalTruth,
         .limits = "entries 0, or at least 1e-70 of their column's largest; results that are not below 1e-290",
         .within = haveUsualProportions},
        [](const Arguments& a) { return normalMatrix(matrixAt(a, 0)); },
        []<typename T>(const ArgumentsOf<T>& a) { return glm::inverseTranspose(glm::mat<3, 3, T>(matrixAt(a, 0))); }));
    return list;
}

}  // namespace mv::accuracy
