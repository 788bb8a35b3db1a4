// The usual eases: the curves that animation programs and style sheets offer beside those of mv/motion/ease.h.
//
// As those, each takes t from 0 to 1, refuses others, and has 0 at 0 and 1 at 1 exactly; the slope is the velocity, 1 being
// that of even motion.
#pragma once

namespace mv {

// At which end a motion is eased. `in` starts slowly, and is the curve as its formula is given below; `out` is the same
// backwards, 1 - in(1 - t); inOut does one half by each: in(2t)/2, then 1 - in(2 - 2t)/2.
enum class EaseSide { in, out, inOut };

// t^3. Slope 3t^2. Equals the curve with exponent 3 of Penner, "Robert Penner's Programming Macromedia Flash MX" (2002),
// chapter 7, as those below are his of their names.
double cubicEase(double t, EaseSide side);
double cubicEaseSlope(double t, EaseSide side);

// 1 - cos(90 t degrees), of which every digit is right at small t, too. inOut is half a turn of a wheel seen from the side.
double sineEase(double t, EaseSide side);
double sineEaseSlope(double t, EaseSide side);

// t^2 ((s + 1) t - s) with s = 1.70158: it first goes back by a tenth of the way.
// Trap: Penner's inOut has s times 1.525, so that it, too, goes back by a tenth; here the halves are those of in, a twentieth.
double backEase(double t, EaseSide side);
double backEaseSlope(double t, EaseSide side);

// -2^(10t - 10) sin(120 (10t - 10.75) degrees): swings before it goes. out comes to rest as what hangs on a spring.
// Trap: the formula has 2^-11, 0.05 % of the way, at t = 0, and jumps from the 0 there; the slope is the formula's.
double elasticEase(double t, EaseSide side);
double elasticEaseSlope(double t, EaseSide side);

// Parabolas of a ball that bounces: out falls in 4/11 of the time, then comes back to 1/4, 1/16 and 1/64 of its height.
// The slope jumps where it touches the ground, and is there the one after it.
double bounceEase(double t, EaseSide side);
double bounceEaseSlope(double t, EaseSide side);

// Stays, and jumps at the end of each of `steps` equal parts of the time: floor(steps t)/steps. Equals CSS steps(n, jump-end).
// The function has no slope but 0. Trap: steps t is rounded, so 0.29 of a hundred steps is at 28. Refused: steps
// outside 1 to 1e6.
double stepsEase(double t, int steps);

}  // namespace mv
