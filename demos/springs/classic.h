// The known stiff problems as curves over time, by a method of one's choice. No GL but in drawing.
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "mv/geometry/plot.h"
#include "mv/gl/drawing.h"
#include "mv/motion/ode_adaptive.h"
#include "mv/motion/ode_method.h"
#include "mv/motion/ode_problems.h"

namespace mv {

// A problem, and how its solution is shown best.
struct Classic {
    OdeCase ode;
    Axis time, value;
    struct Curve {
        std::size_t component;
        std::string name;
        double factor = 1;  // that the curve is drawn higher by
    };
    std::vector<Curve> curves;
};
// A case of odeCases(), by its place there. Refused: a place that there is not.
Classic classic(std::size_t which);

struct ClassicSolution {
    std::vector<double> times;
    std::vector<std::vector<double>> states;  // at these times
    OdeResult result;
    std::optional<double>
        error;  // the largest of a component at the end, relative to it; none without an end or a reference
    std::optional<Confirmation> confirmation;  // where it was asked for and the end was reached
};
// With a tolerance the method chooses its steps, without one (0) there are so many equal ones. `isConfirmed`: what a tenth of
// the tolerance makes is compared, too. Refused: a tolerance for a method that has no estimate of its error, symplectic Euler
// or Verlet on what is not mechanical.
ClassicSolution solveClassic(const Classic& classic, OdeMethod method, double tolerance, int steps,
                             bool isConfirmed = false);

// Axes, curves with their names, and the reference's end as rings at the right, in that box of the pane.
void drawClassic(Drawing& drawing, const Box& box, const Classic& classic, const ClassicSolution& solution);

}  // namespace mv
