#include "mv/motion/ode_method.h"

#include <cmath>

#include "mv/error.h"

namespace mv {

std::string_view methodName(OdeMethod method) {
    switch (method) {
        case OdeMethod::explicitEuler:
            return "explicit Euler";
        case OdeMethod::symplecticEuler:
            return "symplectic Euler";
        case OdeMethod::velocityVerlet:
            return "velocity Verlet";
        case OdeMethod::explicitMidpoint:
            return "explicit midpoint";
        case OdeMethod::rungeKutta4:
            return "Runge-Kutta 4";
        case OdeMethod::dormandPrince:
            return "Dormand-Prince 5(4)";
        case OdeMethod::implicitEuler:
            return "implicit Euler";
        case OdeMethod::implicitMidpoint:
            return "implicit midpoint";
        case OdeMethod::bdf2:
            return "BDF2";
        case OdeMethod::rodas:
            return "RODAS 4(3)";
        case OdeMethod::radau:
            return "Radau IIA 5";
    }
    throw Error("methodName", "must be one of OdeMethod");
}

int methodOrder(OdeMethod method) {
    switch (method) {
        case OdeMethod::explicitEuler:
        case OdeMethod::symplecticEuler:
        case OdeMethod::implicitEuler:
            return 1;
        case OdeMethod::velocityVerlet:
        case OdeMethod::explicitMidpoint:
        case OdeMethod::implicitMidpoint:
        case OdeMethod::bdf2:
            return 2;
        case OdeMethod::rungeKutta4:
        case OdeMethod::rodas:
            return 4;
        case OdeMethod::dormandPrince:
        case OdeMethod::radau:
            return 5;
    }
    throw Error("methodOrder", "must be one of OdeMethod");
}

bool needsMechanical(OdeMethod method) {
    return method == OdeMethod::symplecticEuler || method == OdeMethod::velocityVerlet;
}

bool isImplicit(OdeMethod method) {
    return method == OdeMethod::implicitEuler || method == OdeMethod::implicitMidpoint || method == OdeMethod::bdf2 ||
           method == OdeMethod::rodas || method == OdeMethod::radau;
}

bool isAdaptive(OdeMethod method) {
    return method == OdeMethod::dormandPrince || method == OdeMethod::rodas || method == OdeMethod::radau;
}

const ButcherTableau& tableau(OdeMethod method) {
    // clang-format off
    static const ButcherTableau explicitEuler{1, {0}, {1}, {0}};
    static const ButcherTableau explicitMidpoint{2,
        {0,       0,
         1.0 / 2, 0},
        {0, 1}, {0, 1.0 / 2}};
    static const ButcherTableau rungeKutta4{4,
        {0,       0,       0, 0,
         1.0 / 2, 0,       0, 0,
         0,       1.0 / 2, 0, 0,
         0,       0,       1, 0},
        {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6}, {0, 1.0 / 2, 1.0 / 2, 1}};
    static const ButcherTableau dormandPrince{7,
        {0,                0,                 0,                0,              0,                 0,         0,
         1.0 / 5,          0,                 0,                0,              0,                 0,         0,
         3.0 / 40,         9.0 / 40,          0,                0,              0,                 0,         0,
         44.0 / 45,        -56.0 / 15,        32.0 / 9,         0,              0,                 0,         0,
         19372.0 / 6561,   -25360.0 / 2187,   64448.0 / 6561,   -212.0 / 729,   0,                 0,         0,
         9017.0 / 3168,    -355.0 / 33,       46732.0 / 5247,   49.0 / 176,     -5103.0 / 18656,   0,         0,
         35.0 / 384,       0,                 500.0 / 1113,     125.0 / 192,    -2187.0 / 6784,    11.0 / 84, 0},
        {35.0 / 384,       0,                 500.0 / 1113,     125.0 / 192,    -2187.0 / 6784,    11.0 / 84, 0},
        {0, 1.0 / 5, 3.0 / 10, 4.0 / 5, 8.0 / 9, 1, 1},
        {71.0 / 57600, 0, -71.0 / 16695, 71.0 / 1920, -17253.0 / 339200, 22.0 / 525, -1.0 / 40}};
    // clang-format on
    static const ButcherTableau implicitEuler{1, {1}, {1}, {1}};
    static const ButcherTableau implicitMidpoint{1, {1.0 / 2}, {1}, {1.0 / 2}};
    switch (method) {
        case OdeMethod::explicitEuler:
            return explicitEuler;
        case OdeMethod::explicitMidpoint:
            return explicitMidpoint;
        case OdeMethod::rungeKutta4:
            return rungeKutta4;
        case OdeMethod::dormandPrince:
            return dormandPrince;
        case OdeMethod::implicitEuler:
            return implicitEuler;
        case OdeMethod::implicitMidpoint:
            return implicitMidpoint;
        default:
            throw Error("tableau", "must be asked for a Runge-Kutta method", methodName(method));
    }
}

const RosenbrockCoefficients& rodasCoefficients() {
    static const RosenbrockCoefficients coefficients{
        .gamma = 0.25,
        .a = {{{},
               {1.544},
               {0.9466785280815826, 0.2557011698983284},
               {3.314825187068521, 2.896124015972201, 0.9986419139977817},
               {1.221224509226641, 6.019134481288629, 12.53708332932087, -0.6878860361058950},
               {1.221224509226641, 6.019134481288629, 12.53708332932087, -0.6878860361058950, 1}}},
        .c = {{{},
               {-5.6688},
               {-2.430093356833875, -0.2063599157091915},
               {-0.1073529058151375, -9.594562251023355, -20.47028614809616},
               {7.496443313967647, -10.24680431464352, -33.99990352819905, 11.70890893206160},
               {8.083246795921522, -7.981132988064893, -31.52159432874371, 16.31930543123136, -6.058818238834054}}},
        .alpha = {0, 0.386, 0.21, 0.63, 1, 1},
        .d = {0.25, -0.1043, 0.1035, -0.0362, 0, 0},
        .m = {1.221224509226641, 6.019134481288629, 12.53708332932087, -0.6878860361058950, 1, 1},
        .dense = {
            {{10.12623508344586, -7.487995877610167, -34.80091861555747, -7.992771707568823, 1.025137723295662},
             {-0.6762803392801253, 6.087714651680015, 16.43084320892478, 24.76722511418386, -6.594389125716872}}}};
    return coefficients;
}

const RadauCoefficients& radauCoefficients() {
    static const RadauCoefficients coefficients = [] {
        const double root = std::sqrt(6.0), third = std::cbrt(3.0), ninth = std::cbrt(9.0);
        RadauCoefficients r{
            .a = {{{(88 - 7 * root) / 360, (296 - 169 * root) / 1800, (-2 + 3 * root) / 225},
                   {(296 + 169 * root) / 1800, (88 + 7 * root) / 360, (-2 - 3 * root) / 225},
                   {(16 - root) / 36, (16 + root) / 36, 1.0 / 9}}},
            .c = {(4 - root) / 10, (4 + root) / 10, 1},
            .transform = {{{9.1232394870892942792e-2, -0.14125529502095420843, -3.0029194105147424492e-2},
                           {0.24171793270710701896, 0.20412935229379993199, 0.38294211275726193779},
                           {0.96604818261509293619, 1, 0}}},
            .inverse = {{{4.3255798900631553510, 0.33919925181580986954, 0.54177053993587487119},
                         {-4.1787185915519047273, -0.32768282076106238708, 0.47662355450055045196},
                         {-0.50287263494578687595, 2.5719269498556054292, -0.59603920482822492497}}},
            .real = 3 - third + ninth,
            .complex = {3 + (third - ninth) / 2, std::sqrt(3.0) / 2 * (third + ninth)},
            .error = {-(13 + 7 * root) / 3, (-13 + 7 * root) / 3, -1.0 / 3}};
        return r;
    }();
    return coefficients;
}

}  // namespace mv
