#include "mv/study/claims.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mv/error.h"

using namespace mv;
using namespace mv::claims;

namespace {

StudyRow made(const std::string& scene, const std::string& method, const std::string& p, double rms, double ms) {
    StudyRow row;
    row.scene = scene;
    row.method = method;
    row.parameter = p;
    row.all = {rms, 2 * rms, rms / 10, 1000};
    row.awayFromEdges = {0, 0, 0, 900};
    row.msMedian = ms;
    row.rounds = 7;
    row.counts = {{"draws", 3}};
    return row;
}

// Two scenes; "falls" is 1/p, "stays" stops at 0.25, "once" is one row, and what failed says why.
StudyRun run() {
    StudyRun run;
    for (const char* scene : {"hill", "vale"}) {
        for (const double p : {1.0, 2.0, 4.0, 8.0}) {
            run.rows.push_back(made(scene, "falls", std::to_string(int(p)), 1 / p, p));
            run.rows.push_back(made(scene, "stays", std::to_string(int(p)), p < 4 ? 1 / p : 0.25, 2 * p));
        }
    }
    run.rows.push_back(made("hill", "once", "", 0.125, 3));
    run.rows.push_back(made("vale", "refused", "9", 0, 0));
    run.rows.back().status = "--p: must be below 9";
    return run;
}

std::string problem(const Predicate& predicate, const StudyRun& of = run()) {
    try {
        return "evaluated: " + evaluate(of, predicate).text;
    } catch (const Error& error) {
        return error.what();
    }
}

std::vector<std::string> failures(const Predicate& predicate) {
    const Evaluation evaluation = evaluate(run(), predicate);
    EXPECT_EQ(evaluation.holds, evaluation.failures.empty());
    return evaluation.failures;
}

using Texts = std::vector<std::string>;

}  // namespace

TEST(Claims, slope_is_of_each_line) {
    const Evaluation fall = evaluate(run(), slope(of::rms, rows("falls"), -1.1, -0.9));
    EXPECT_TRUE(fall.holds);
    EXPECT_EQ(fall.text, "slope of rms over p, falls: -1 in 2 scenes; claimed -1.1 .. -0.9");
    EXPECT_EQ(failures(slope(of::error, rows("falls", "stays").in("vale"), -1.1, -0.9)),
              Texts{"vale, stays: slope of error over p is -0.7"});
    EXPECT_TRUE(evaluate(run(), slope(of::time, rows("falls", "stays"), 0.999, 1.001)).holds);
    EXPECT_EQ(problem(slope(of::rms, rows("falls").from(4), -2, 0)),
              "claim: must have three rows for a slope, hill, falls");
    EXPECT_EQ(problem(slope(of::wrongAwayFromEdges, rows("falls"), -2, 0)),
              "claim: must have three rows for a slope, hill, falls");
}

TEST(Claims, value_is_of_every_row) {
    EXPECT_TRUE(failures(value(of::rms, rows("falls").upTo(4), 0.25, 1)).empty());
    EXPECT_TRUE(failures(zero(of::wrongAwayFromEdges, rows("falls", "stays", "once"))).empty());
    EXPECT_EQ(failures(atMost(of::rms, rows("stays").in("hill").from(2), 0.25)), Texts{"hill, stays 2: rms is 0.5"});
    EXPECT_EQ(failures(atLeast(of::wrong, rows("once"), 1.5)), Texts{"hill, once: wrong % is 1.25"});
    EXPECT_EQ(failures(zero(of::count("draws"), rows("once"))), Texts{"hill, once: draws is 3"});
    EXPECT_EQ(failures(atMost(of::max, rows("refused"), 1)),
              Texts{"vale, refused 9: max is not there: --p: must be below 9"});
    EXPECT_EQ(evaluate(run(), atMost(of::rms, rows("falls").at(8), 0.2)).text,
              "rms, falls at 8: 0.125 in 2 scenes; claimed at most 0.2");
}

TEST(Claims, ratio_has_a_partner_for_each_row) {
    EXPECT_TRUE(failures(ratio(of::rms, rows("falls"), rows("stays"), 0.5, 1)).empty());
    EXPECT_EQ(failures(ratio(of::time, rows("stays").in("hill").at(8), rows("falls"), 0, 1.9)),
              Texts{"hill, stays 8: ms of stays in hill at 8 by that of falls is 2"});
    // Against one row: that of the same scene, or of the scene that is named.
    EXPECT_TRUE(failures(ratio(of::rms, rows("falls"), rows("falls").at(8), 1, 8)).empty());
    EXPECT_TRUE(failures(ratio(of::rms, rows("falls").in("vale"), rows("once").in("hill"), 1, 8)).empty());
    EXPECT_TRUE(failures(ratio(of::wrongAwayFromEdges, rows("falls"), rows("stays"), 1, 1)).empty()) << "0 of 0 is 1";
    EXPECT_FALSE(failures(ratio(of::rms, rows("falls"), rows("stays").at(1), 1, HUGE_VAL)).empty());
    EXPECT_EQ(problem(ratio(of::rms, rows("falls"), rows("once"), 0, 9)),
              "claim: must compare each row with one other, vale, falls 1");
    EXPECT_EQ(problem(ratio(of::rms, rows("once"), rows("falls"), 0, 9)),
              "claim: must compare each row with one other, hill, once");
}

TEST(Claims, settled_is_the_largest_by_the_smallest) {
    EXPECT_TRUE(failures(settled(of::rms, rows("stays").from(4), 1)).empty());
    EXPECT_EQ(failures(settled(of::rms, rows("stays").in("vale").from(2), 1.5)),
              Texts{"vale, stays: largest rms by the smallest is 2"});
    EXPECT_EQ(problem(settled(of::rms, rows("once"), 1)), "claim: must have two rows that can differ, hill, once");
}

TEST(Claims, unbeaten_is_nearer_or_faster) {
    // "stays" 4 takes 8 ms for 0.25, "falls" 4 only 4 ms; and "falls" 8 has 0.125 for 8 ms.
    EXPECT_TRUE(failures(unbeaten(rows("falls"), rows("stays"))).empty());
    EXPECT_EQ(failures(unbeaten(rows("stays").in("vale").at(8), rows("falls"))),
              (Texts{"vale, stays 8 is beaten by vale, falls 4", "vale, stays 8 is beaten by vale, falls 8"}));
    EXPECT_EQ(failures(unbeaten(rows("falls").in("hill").at(8), rows("once"))),
              Texts{"hill, falls 8 is beaten by hill, once"});
    EXPECT_EQ(problem(unbeaten(rows("falls").in("vale"), rows("once"))),
              "claim: must have rivals in the same scene, falls in vale");
}

TEST(Claims, fails_for_the_reason_that_is_given) {
    EXPECT_TRUE(failures(fails(rows("refused"), "must be below 9")).empty());
    EXPECT_EQ(failures(fails(rows("refused"), "must be above")),
              Texts{"vale, refused 9: does not fail because 'must be above': --p: must be below 9"});
    EXPECT_EQ(failures(fails(rows("once"), "must be")), Texts{"hill, once: does not fail because 'must be': ok"});
}

// A claim that matches nothing would hold of anything.
TEST(Claims, none_is_about_nothing) {
    EXPECT_EQ(problem(zero(of::rms, rows("falls", "rises"))), "claim: must be about rows that there are, rises");
    EXPECT_EQ(problem(zero(of::rms, rows("falls").in("moor"))),
              "claim: must be about rows that there are, falls in moor");
    EXPECT_EQ(problem(zero(of::rms, rows("falls").at(3))), "claim: must be about rows that there are, falls at 3");
    EXPECT_EQ(problem(zero(of::rms, rows("once").from(1))), "claim: must be about rows that there are, once from 1");
    EXPECT_EQ(problem(fails(rows("falls").from(9), "")), "claim: must be about rows that there are, falls from 9");
    EXPECT_EQ(problem(zero(of::count("taps"), rows("once"))),
              "claim: must be about what a frame counts, taps of hill, once");
    StudyRun untimed = run();
    for (StudyRow& row : untimed.rows) row.rounds = 0;
    EXPECT_EQ(problem(atMost(of::time, rows("once"), 9), untimed),
              "claim: must be about times that were measured, hill, once");
    EXPECT_EQ(problem(unbeaten(rows("once"), rows("falls")), untimed),
              "claim: must be about times that were measured, hill, once");
    EXPECT_TRUE(unbeaten(rows("once"), rows("falls")).asksTimes());
    EXPECT_TRUE(slope(of::time, rows("falls"), 0, 1).asksTimes());
    EXPECT_FALSE(slope(of::rms, rows("falls"), 0, 1).asksTimes());
}
