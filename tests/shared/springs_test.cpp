// The parts that springs and its study share: scenes, the classics' solutions, and what is drawn of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "mv/error.h"
#include "mv/motion/ode_adaptive.h"
#include "mv/motion/ode_stability.h"
#include "springs/classic.h"
#include "springs/figure.h"
#include "springs/game.h"
#include "springs/scenes.h"

using namespace mv;

namespace {

// At rest where it is slack, without gravity: nothing is pulled, but by the hand where it is elsewhere.
TEST(SpringScenes, NothingPullsWhereItIsSlack) {
    for (const SpringScene scene :
         {SpringScene::chain, SpringScene::net, SpringScene::cloth, SpringScene::threeMasses, SpringScene::oneSpring}) {
        for (const int masses : {2, 5, 8}) {
            const SpringSetup setup = makeSprings(
                {.scene = scene, .masses = masses, .stiffness = 1e6, .damping = 3, .gravity = 0, .grip = 40});
            EXPECT_EQ(setup.hasHand, isHung(scene));
            const auto state = springState(setup.slack, std::vector<vec3>(setup.slack.size(), vec3(0)));
            std::vector<double> slope(state.size());
            springProblem(setup.system).slope(0, state, slope);
            // Roundings of 1e-16 of a length, times k/m = 1e7
            for (const double rate : slope) EXPECT_NEAR(rate, 0, 1e-7);
        }
    }
    EXPECT_THROW(makeSprings({.masses = 1}), Error);
    EXPECT_THROW(springProblem(makeSprings({.stiffness = -1}).system), Error);
}

TEST(SpringScenes, TheHandIsTheLastPoint) {
    const SpringSetup setup = makeSprings({.scene = SpringScene::cloth, .masses = 3, .grip = 7, .hand = vec2(1, -1)});
    EXPECT_EQ(setup.system.points.size(), 10U);
    EXPECT_TRUE(setup.system.points.back().isFixed);
    EXPECT_EQ(positionOf(setup.start, 9), vec3(1, -1, 0));
    EXPECT_EQ(setup.system.springs.back().stiffness, 7);
    EXPECT_EQ(setup.system.springs.back().b, 9U);
    EXPECT_EQ(setup.slack[8], vec3(0.6, -0.4, 0));
    // Twelve along the sides of four squares, eight diagonals, and the hand's
    EXPECT_EQ(setup.system.springs.size(), 21U);
}

// Undamped, damped, critical and beyond, against Dormand-Prince.
TEST(SpringScenes, SwungIsTheExactMotion) {
    for (const double damping : {0.0, 1.0, 20.0, 50.0}) {
        const SpringSettings settings{.scene = SpringScene::oneSpring, .stiffness = 100, .damping = damping};
        const SpringSetup setup = makeSprings(settings);
        const OdeResult end = integrateAdaptive(springProblem(setup.system), OdeMethod::dormandPrince, 0, 0.3,
                                                setup.start, {.relative = 1e-12, .absolute = 1e-14});
        const vec2 exact = swung(settings, vec2(pulled, 0), 0.3);
        EXPECT_NEAR(positionOf(end.y, 1).x, exact.x, 1e-11) << damping;
        EXPECT_NEAR(velocityOf(end.y, 1).x, exact.y, 1e-10) << damping;
        const vec2 twice = swung(settings, swung(settings, vec2(pulled, 0), 0.1), 0.2);
        EXPECT_NEAR(twice.x, exact.x, 1e-15);
        if (damping > 0) continue;
        // w = 10: three radians
        EXPECT_NEAR(turnBetween(settings, setup.start, end.y), 3, 1e-9);
        EXPECT_NEAR(turnBetween(settings, end.y, setup.start), 2 * pi - 3, 1e-9);
    }
}

TEST(SpringPictures, GridIsTheAmplification) {
    const std::vector<std::complex<double>> numbers{{-30, 2}, {0, 16.7}};
    const Plot plot = stabilityPlot({0, 0, 480, 280}, numbers);
    for (const std::complex<double>& z : numbers) {
        EXPECT_TRUE(plot.x.low < z.real() && z.real() < plot.x.high && plot.y.low < z.imag() && z.imag() < plot.y.high);
    }
    const MeshData grid = stabilityGrid(OdeMethod::implicitEuler, plot);
    for (const fvec3& vertex : grid.positions) {
        const double growth = amplification(OdeMethod::implicitEuler, {vertex.x, vertex.y});
        // Rounded to floats: next to the pole by more
        if (growth >= 10) continue;
        EXPECT_NEAR((1 + vertex.z) / (1 - vertex.z), growth, 1e-3);
        EXPECT_TRUE(vertex.z >= -1 && vertex.z <= 1);
    }
}

TEST(SpringPictures, WordsAreWrapped) {
    EXPECT_EQ(wrapped("", 5), std::vector<std::string>{""});
    EXPECT_EQ(wrapped("one two three", 7), (std::vector<std::string>{"one two", "three"}));
    EXPECT_EQ(wrapped("incredible one", 3), (std::vector<std::string>{"incredible", "one"}));
}

TEST(ClassicCurves, EndWhereTheirCasesEnd) {
    for (std::size_t i = 0; i < 8; ++i) {
        const Classic one = classic(i);
        SCOPED_TRACE(one.ode.name);
        const ClassicSolution solution = solveClassic(one, OdeMethod::rodas, 1e-5, 0);
        EXPECT_TRUE(solution.result.reachedEnd()) << solution.result.failure;
        EXPECT_EQ(solution.result.t, one.ode.end);
        EXPECT_EQ(solution.error.has_value(), !one.ode.reference.empty());
        // In order, from the start to the end, and the end is the result
        EXPECT_TRUE(std::ranges::is_sorted(solution.times));
        EXPECT_EQ(solution.times.size(), 801U);
        for (std::size_t c = 0; c < one.ode.initial.size(); ++c) {
            const double end = solution.result.y[c];
            EXPECT_NEAR(solution.states.back()[c], end, 1e-9 * (1 + std::abs(end)));
        }
    }
    EXPECT_THROW(classic(8), Error);
    EXPECT_THROW(solveClassic(classic(3), OdeMethod::velocityVerlet, 0, 100), Error);
    EXPECT_THROW(solveClassic(classic(3), OdeMethod::implicitEuler, 1e-3, 100), Error);
    // By equal steps: all of them, and what gives up says so
    EXPECT_EQ(solveClassic(classic(0), OdeMethod::velocityVerlet, 0, 100).times.size(), 101U);
    const ClassicSolution lost = solveClassic(classic(3), OdeMethod::rungeKutta4, 0, 1000);
    EXPECT_FALSE(lost.result.reachedEnd());
    EXPECT_FALSE(lost.error.has_value());
}

SpringRule undamped(SpringScene scene, std::optional<OdeMethod> method) {
    return {
        .springs = {.scene = scene, .masses = 3, .grip = 20, .hand = vec2(0.8, -0.6)}, .method = method, .substeps = 2};
}

TEST(SpringGame, WhatAHandPutsInIsWork) {
    SpringRule rule = undamped(SpringScene::net, std::nullopt);
    SpringGame game(rule);
    EXPECT_GT(game.first(), 0);
    for (int index = 1; index <= 20; ++index) game.advance(rule, index);
    EXPECT_EQ(game.work(), 0);
    const double before = game.energy();
    const SpringGame copy = game;
    rule.springs.hand = vec2(-1, 1);
    game.advance(rule, 21);
    EXPECT_NE(game.work(), 0);
    // Energy-momentum keeps what was put in; 1e-12 of it is what Newton's method leaves
    EXPECT_NEAR(game.energy(), before + game.work(), 1e-11 * game.whole());
    EXPECT_EQ(copy.energy(), before) << "a copy is its own";
    EXPECT_EQ(game.graph().size(), 22U);
    EXPECT_EQ(game.stepsNow(), 2);
}

// Its computed motion sleeps after some steps, undamped; the true one does not.
TEST(SpringGame, TheTrueHandGoesOnWhereTheComputedOneRests) {
    SpringRule rule = undamped(SpringScene::oneSpring, OdeMethod::implicitEuler);
    rule.springs.stiffness = 1e6;
    SpringGame game(rule);
    for (int index = 1; index <= 60; ++index) game.advance(rule, index);
    ASSERT_TRUE(game.rests());
    EXPECT_EQ(game.stepsNow(), 0);
    const vec2 exact = swung(rule.springs, vec2(pulled, 0), 1);
    EXPECT_NEAR(game.exact().x, exact.x, 1e-11) << "roundings of 120 turns by 8 rad";
    game.advance(rule, 61);
    EXPECT_NE(game.exact().x, exact.x);
}

TEST(SpringGame, StopsInWordsWhereItIs) {
    SpringRule rule = undamped(SpringScene::chain, OdeMethod::explicitEuler);
    rule.springs.stiffness = 1e6;
    SpringGame game(rule);
    int index = 1;
    for (; game.failure().empty() && index < 1000; ++index) game.advance(rule, index);
    EXPECT_EQ(game.failure().rfind("stopped at step ", 0), 0U) << game.failure();
    const std::vector<double> state = game.state();
    for (const double each : state) EXPECT_TRUE(std::isfinite(each));
    game.advance(rule, index);
    EXPECT_EQ(game.state(), state);
    EXPECT_EQ(game.stepsNow(), 0);
    EXPECT_THROW(SpringGame({.springs = {.masses = 1}, .method = OdeMethod::velocityVerlet}), Error);
}

}  // namespace
