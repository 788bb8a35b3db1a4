// The statements of a study: claims, sentences that the rows of its table must bear out, and notes, which explain.
//
//   study.says = {claim("half-for-twice", "A map twice as large misjudges half as many pixels.",
//                       {slope(Of::error, rows("maps"), -1.1, -0.9)}),
//                 note("Texels finer than pixels are not seen.")};
//
// mv/study/claims.h evaluates them. The bounds of a predicate are those of its sentence, rounded as the sentence
// rounds. A sentence about noisy numbers, times above all, is as wide as the noise.
#pragma once
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace mv {

// A number of a row, in the unit that its table shows.
struct StudyNumber {
    enum class Kind { error, rms, max, wrong, wrongAwayFromEdges, time, count } kind;
    const char* name = "";  // of a count: "fragments"
};

// Some rows of a study: those of these methods, in this scene ("": all), with p from .. to.
struct StudyRows {
    std::vector<std::string> methods;
    std::string scene = {};
    double low = -HUGE_VAL, high = HUGE_VAL;

    StudyRows in(std::string name) const { return {methods, std::move(name), low, high}; }
    StudyRows at(double p) const { return {methods, scene, p, p}; }
    StudyRows from(double p) const { return {methods, scene, p, high}; }
    StudyRows upTo(double p) const { return {methods, scene, low, p}; }
};

// A predicate that can be evaluated.
struct Predicate {
    enum class Kind { slope, value, ratio, settled, unbeaten, fails } kind;
    StudyNumber number;
    StudyRows which;
    StudyRows against = {};  // of a ratio, its lower rows; of unbeaten, whom nobody is beaten by
    double low = -HUGE_VAL, high = HUGE_VAL;
    std::string reason = {};  // of a row that fails, a part of it

    bool asksTimes() const { return kind == Kind::unbeaten || number.kind == StudyNumber::Kind::time; }
};

// One sentence, or a few that belong together.
struct Saying {
    std::string id;  // of a claim: lower case words joined by hyphens; "" for a note
    std::string sentence;
    std::vector<Predicate> predicates = {};
    bool isClaim() const { return !id.empty(); }
};

// The functions by which a study file writes them.
namespace claims {

// The numbers of a row, by name.
namespace of {
inline constexpr StudyNumber error{StudyNumber::Kind::error};  // what the plot shows: rms, wrong or max, by Study::axis
inline constexpr StudyNumber rms{StudyNumber::Kind::rms};
inline constexpr StudyNumber max{StudyNumber::Kind::max};
inline constexpr StudyNumber wrong{StudyNumber::Kind::wrong};                            // percent
inline constexpr StudyNumber wrongAwayFromEdges{StudyNumber::Kind::wrongAwayFromEdges};  // percent
inline constexpr StudyNumber time{StudyNumber::Kind::time};                              // milliseconds
// A number that a frame counts, by its name in the table "Work of a frame".
constexpr StudyNumber count(const char* name) { return {StudyNumber::Kind::count, name}; }
}  // namespace of

// All rows of these methods.
template <class... Names>
StudyRows rows(Names... methods) {
    return {{std::string(methods)...}};
}

// In every scene, and for each method by itself, the number goes as p^s with s in low .. high: the least-squares slope of
// the logarithms, of three rows at least.
inline Predicate slope(StudyNumber number, StudyRows which, double low, double high) {
    return {Predicate::Kind::slope, number, std::move(which), {}, low, high};
}
// The number of every row is in low .. high.
inline Predicate value(StudyNumber number, StudyRows which, double low, double high) {
    return {Predicate::Kind::value, number, std::move(which), {}, low, high};
}
inline Predicate atMost(StudyNumber number, StudyRows which, double high) {
    return value(number, std::move(which), -HUGE_VAL, high);
}
inline Predicate atLeast(StudyNumber number, StudyRows which, double low) {
    return value(number, std::move(which), low, HUGE_VAL);
}
inline Predicate zero(StudyNumber number, StudyRows which) { return value(number, std::move(which), 0, 0); }
// Every row's number is low .. high times that of its partner: the only row of `against` in the same scene (or in the
// scene that `against` names) or, of several, that with the same p. 0 by 0 is 1.
inline Predicate ratio(StudyNumber number, StudyRows which, StudyRows against, double low, double high) {
    return {Predicate::Kind::ratio, number, std::move(which), std::move(against), low, high};
}
// The number moves no more: in every scene and for each method, the largest of the rows, two at least, is at most `factor`
// times the smallest.
inline Predicate settled(StudyNumber number, StudyRows which, double factor) {
    return {Predicate::Kind::settled, number, std::move(which), {}, 1, factor};
}
// No row of `against` in the same scene is at least as near to the reference and at least as fast, and one of both more.
inline Predicate unbeaten(StudyRows which, StudyRows against) {
    return {Predicate::Kind::unbeaten, of::error, std::move(which), std::move(against)};
}
// Every row has no number, for a reason of which `reason` is a part.
inline Predicate fails(StudyRows which, std::string reason) {
    return {Predicate::Kind::fails, of::error, std::move(which), {}, -HUGE_VAL, HUGE_VAL, std::move(reason)};
}

// Its rows bear it out: all predicates hold.
inline Saying claim(std::string id, std::string sentence, std::vector<Predicate> predicates) {
    return {std::move(id), std::move(sentence), std::move(predicates)};
}
// A definition or an explanation, which no row can show to be wrong.
inline Saying note(std::string sentence) { return {"", std::move(sentence)}; }

}  // namespace claims
}  // namespace mv
