#include "bench/cvode.h"

#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_config.h>
#include <sunlinsol/sunlinsol_band.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_band.h>
#include <sunmatrix/sunmatrix_dense.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <algorithm>
#include <cstdlib>
#include <memory>

#include "mv/error.h"

namespace mv::bench {
namespace {

using work_precision::Outcome;
using work_precision::Problem;
using work_precision::Solver;

void require(int flag, const char* call) {
    if (flag < 0) throw Error("CVODE", std::string(call) + " must succeed", std::to_string(flag));
}

// The objects that CVODE keeps for one problem.
class Integrator {
  public:
    Integrator(const Problem& problem, int family) : problem_(problem), slope_(problem.ode.initial.size()) {
        const auto n = static_cast<sunindextype>(problem.ode.initial.size());
        require(SUNContext_Create(nullptr, &context_), "SUNContext_Create");
        y_ = N_VNew_Serial(n, context_);
        memory_ = CVodeCreate(family, context_);
        require(CVodeInit(memory_, slopeOf, problem.ode.start, y_), "CVodeInit");
        require(CVodeSetUserData(memory_, this), "CVodeSetUserData");
        require(CVodeSetMaxNumSteps(memory_, work_precision::mostSteps), "CVodeSetMaxNumSteps");
        require(CVodeSetErrHandlerFn(
                    memory_, [](int, const char*, const char*, char*, void*) {}, nullptr),
                "CVodeSetErrHandlerFn");
        if (family == CV_ADAMS) {
            fixedPoint_ = SUNNonlinSol_FixedPoint(y_, 0, context_);
            require(CVodeSetNonlinearSolver(memory_, fixedPoint_), "CVodeSetNonlinearSolver");
            return;
        }
        const OdeProblem& ode = problem.ode.problem;
        if (ode.sparseJacobian) {  // the chain's: positions and velocities side by side
            isInterleaved_ = true;
            state_.resize(slope_.size());
            matrix_ = SUNBandMatrix(n, bandwidth, bandwidth, context_);
            linear_ = SUNLinSol_Band(y_, matrix_, context_);
        } else {
            matrix_ = SUNDenseMatrix(n, n, context_);
            linear_ = SUNLinSol_Dense(y_, matrix_, context_);
        }
        require(CVodeSetLinearSolver(memory_, linear_, matrix_), "CVodeSetLinearSolver");
        if (ode.sparseJacobian || ode.jacobian) require(CVodeSetJacFn(memory_, jacobianOf), "CVodeSetJacFn");
    }
    Integrator(const Integrator&) = delete;
    Integrator& operator=(const Integrator&) = delete;
    ~Integrator() {
        CVodeFree(&memory_);
        if (fixedPoint_) SUNNonlinSolFree(fixedPoint_);
        if (linear_) SUNLinSolFree(linear_);
        if (matrix_) SUNMatDestroy(matrix_);
        N_VDestroy(y_);
        SUNContext_Free(&context_);
    }

    Outcome run(double tolerance) {
        const OdeCase& ode = problem_.ode;
        double* const y = N_VGetArrayPointer(y_);
        for (std::size_t i = 0; i < slope_.size(); ++i) y[place(i)] = ode.initial[i];
        require(CVodeReInit(memory_, ode.start, y_), "CVodeReInit");
        require(CVodeSStolerances(memory_, tolerance, tolerance * problem_.floor), "CVodeSStolerances");
        Outcome outcome;
        for (const double stop : problem_.stops) {
            double t = 0;
            const int flag = CVode(memory_, stop, y_, &t, CV_NORMAL);
            if (flag < 0) {
                char* const name = CVodeGetReturnFlagName(flag);
                outcome.failure = "gave up at t = " + numberText(t) + ": " + name;
                std::free(name);  // NOLINT: it is CVODE's
                break;
            }
            std::vector<double> state(slope_.size());
            for (std::size_t i = 0; i < state.size(); ++i) state[i] = y[place(i)];
            outcome.states.push_back(std::move(state));
        }
        long steps = 0, evaluations = 0, setups = 0, failed = 0, jacobians = 0, inDifferences = 0, iterations = 0,
             notConverged = 0;
        CVodeGetNumSteps(memory_, &steps);
        CVodeGetNumRhsEvals(memory_, &evaluations);
        CVodeGetNumErrTestFails(memory_, &failed);
        CVodeGetNonlinSolvStats(memory_, &iterations, &notConverged);
        if (linear_) {
            CVodeGetNumLinSolvSetups(memory_, &setups);
            CVodeGetNumJacEvals(memory_, &jacobians);
            CVodeGetNumLinRhsEvals(memory_, &inDifferences);
        }
        outcome.counts = {.evaluations = evaluations + inDifferences,
                          .jacobians = jacobians,
                          .factorizations = setups,
                          .newtonIterations = linear_ ? iterations : 0,
                          .accepted = steps,
                          .rejected = failed + notConverged};
        return outcome;
    }

  private:
    static constexpr sunindextype bandwidth = 3;

    // The place of our component i in CVODE's y.
    std::size_t place(std::size_t i) const {
        const std::size_t half = slope_.size() / 2;
        return !isInterleaved_ ? i : i < half ? 2 * i : 2 * (i - half) + 1;
    }

    static int slopeOf(double t, N_Vector y, N_Vector slope, void* data) {
        auto& self = *static_cast<Integrator*>(data);
        const std::size_t n = self.slope_.size();
        const double* const from = N_VGetArrayPointer(y);
        double* const to = N_VGetArrayPointer(slope);
        const OdeProblem& problem = self.problem_.ode.problem;
        if (!self.isInterleaved_) {
            problem.slope(t, {from, n}, {to, n});
            return 0;
        }
        for (std::size_t i = 0; i < n / 2; ++i) self.state_[i] = from[2 * i], self.state_[n / 2 + i] = from[2 * i + 1];
        problem.slope(t, self.state_, self.slope_);
        for (std::size_t i = 0; i < n / 2; ++i) to[2 * i] = self.slope_[i], to[2 * i + 1] = self.slope_[n / 2 + i];
        return 0;
    }

    static int jacobianOf(double t, N_Vector y, N_Vector, SUNMatrix matrix, void* data, N_Vector, N_Vector, N_Vector) {
        auto& self = *static_cast<Integrator*>(data);
        const std::size_t n = self.slope_.size();
        const OdeProblem& problem = self.problem_.ode.problem;
        const double* const from = N_VGetArrayPointer(y);
        if (self.isInterleaved_) {  // the chain's is constant, and asks for no state
            self.entries_.clear();
            problem.sparseJacobian(t, self.state_, self.entries_);
            for (const MatrixEntry& entry : self.entries_) {
                const auto row = static_cast<sunindextype>(self.place(static_cast<std::size_t>(entry.row)));
                const auto column = static_cast<sunindextype>(self.place(static_cast<std::size_t>(entry.column)));
                SM_ELEMENT_B(matrix, row, column) += entry.value;
            }
            return 0;
        }
        self.rows_.assign(n * n, 0);
        problem.jacobian(t, {from, n}, self.rows_);
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t j = 0; j < n; ++j) {
                SM_ELEMENT_D(matrix, static_cast<sunindextype>(i), static_cast<sunindextype>(j)) =
                    self.rows_[i * n + j];
            }
        }
        return 0;
    }

    const Problem& problem_;
    bool isInterleaved_ = false;
    std::vector<double> slope_, state_, rows_;
    std::vector<MatrixEntry> entries_;
    SUNContext context_ = nullptr;
    N_Vector y_ = nullptr;
    void* memory_ = nullptr;
    SUNMatrix matrix_ = nullptr;
    SUNLinearSolver linear_ = nullptr;
    SUNNonlinearSolver fixedPoint_ = nullptr;
};

Solver solver(const char* name, int family) {
    // One more than ours: its errors are larger.
    std::vector<double> parameters = work_precision::tolerances();
    parameters.push_back(1e-13);
    return {.name = name,
            .hasTolerance = true,
            .parameters = parameters,
            .refusal =
                [family](const Problem& problem, double tolerance) {
                    const std::string& which = problem.ode.name;
                    // Where its tolerance is below the roundings of the stiff springs' forces.
                    if (which == "stiff chain" && tolerance < 1e-11) return "left out: more than a second";
                    const bool isStiff = which != "Pleiades" && which.find("spring") == std::string::npos;
                    return family == CV_ADAMS && isStiff ? "left out: for problems that are not stiff" : "";
                },
            .prepare =
                [family](const Problem& problem, double tolerance) {
                    auto integrator = std::make_shared<Integrator>(problem, family);
                    return [integrator, tolerance] { return integrator->run(tolerance); };
                }};
}

}  // namespace

std::string cvodeVersion() { return SUNDIALS_VERSION; }

std::vector<Solver> cvodeSolvers() { return {solver("CVODE BDF", CV_BDF), solver("CVODE Adams", CV_ADAMS)}; }

}  // namespace mv::bench
