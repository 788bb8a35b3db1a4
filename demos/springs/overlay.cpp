// The words over the pictures of springs, and the places of the pictures.
#include <algorithm>

#include "figure.h"
#include "mv/formatted.h"
#include "springs.h"

namespace mv::springs {

// The left half; the right one's upper and lower half. In an upright picture all three are below each other.
Pane leftOf(const FrameInfo& frame) {
    if (frame.isUpright()) {
        const int below = frame.height() * 3 / 5;
        return {0, below, frame.width(), frame.height() - below};
    }
    return {0, 0, std::max(frame.width() / 2, 1), frame.height()};
}
Pane rightOf(const FrameInfo& frame, bool isUpper) {
    if (frame.isUpright()) {
        const int high = std::max(frame.height() * 3 / 10, 1);
        return {0, isUpper ? high : 0, frame.width(), high};
    }
    const int width = std::max(frame.width() / 2, 1), height = std::max(frame.height() / 2, 1);
    return {frame.width() / 2, isUpper ? frame.height() / 2 : 0, width, height};
}

void drawDots(Gpu& gpu, const Plot& plot, const Pane& pane, const std::vector<Dot>& all) {
    Drawing& drawing = gpu.drawing;
    drawing.in(pane);
    drawing.axes(plot);
    drawing.line(plot.pixel({plot.x.low, 0}), plot.pixel({plot.x.high, 0}), {springGrey, 1});
    for (const Dot& dot : all)
        drawing.point(plot.pixel({dot.z.real(), dot.z.imag()}), 7, dot.grows ? springRed : springInk);
    const long growing = std::ranges::count_if(all, &Dot::grows);
    const vec2 at(plot.box.low.x, pane.height);
    paneWords(drawing, pane, at - vec2(0, 1), "step x eigenvalues; blue: where this method does not grow", springInk);
    paneWords(drawing, pane, at - vec2(0, 22),
              growing > 0 ? std::to_string(growing) + " outside: they grow" : "none outside",
              growing > 0 ? springRed : springInk);
}

void drawMasses(Gpu& gpu, const Settings& s, const Memory& game, const Frame& frame) {
    Drawing& drawing = gpu.drawing;
    const Pane pane = leftOf(frame);
    drawing.in(pane);
    const int lost = drawSprings(drawing, pane, game.setup(), game.state());
    if (sceneOf(s) == SpringScene::oneSpring) drawPhase(drawing, pane, game);
    double top = pane.height - 4.0;
    const auto say = [&](const std::string& text, const vec4& color = springInk) {
        paneWords(drawing, pane, {12, top}, text, color);
        top -= 18;
    };
    const int substeps = s.played.substeps;
    say(std::string(nameOf(s.method)) + ", " + (substeps == 1 ? "one step" : std::to_string(substeps) + " steps") +
        " a frame");
    if (game.rests()) say("at rest: no step is computed");
    if (lost > 0) say(std::to_string(lost) + " are more than 100 m away", springRed);
    if (!game.failure().empty()) {
        for (const std::string& line : wrapped(game.failure(), 56)) say(line, springRed);
        frame.say(game.failure());
    }
    paneWords(drawing, pane, {12, 26}, "springs: blue 10 % shorter than at rest, grey, red 10 % longer", springInk);
}

std::size_t whichClassic(const Settings& s) {
    return static_cast<std::size_t>(s.problem) - static_cast<std::size_t>(Problem::classics);
}

void drawSolved(Gpu& gpu, const Settings& s, const Memory&, const Frame& inPixels) {
    const Frame frame = inPixels.inUnits();
    Drawing& drawing = gpu.drawing;
    const double asked = isAdaptive(asOde(s)) ? s.solved.tolerance : 0;
    const auto& [known, solution] = gpu.solved.of({s.problem, asOde(s), asked, s.solved.steps, s.solved.confirm}, [&] {
        const Classic problem = classic(whichClassic(s));
        return SolvedClassic{problem, solveClassic(problem, asOde(s), asked, s.solved.steps, s.solved.confirm)};
    });
    const Pane pane{0, 0, frame.width(), frame.height()};
    const Box box{
        {std::min(70.0, pane.width / 6.0), std::min(52.0, pane.height / 5.0)},
        {std::max(pane.width - 30.0, pane.width / 6.0 + 1), std::max(pane.height - 112.0, pane.height / 5.0 + 1)}};
    drawing.in(pane);
    drawClassic(drawing, box, known, solution);
    const OdeResult& result = solution.result;
    std::string told = known.ode.name + " by " + nameOf(s.method) + ", " + std::to_string(result.counts.accepted) +
                       " steps, " + std::to_string(result.counts.evaluations) + " evaluations";
    if (solution.error) told += formatted("; off by %.1e at the end (rings: the published values)", *solution.error);
    drawing.text({12, pane.height - 8.0}, told, {15, springInk, vec4(0)});
    double top = pane.height - 26.0;
    const auto tell = [&](const std::string& words, const vec4& ink) {
        for (const std::string& line : wrapped(words, 105)) {
            drawing.text({12, top}, line, {15, ink, vec4(0)});
            top -= 18;
        }
    };
    const std::optional<Confirmation>& confirmed = solution.confirmation;
    if (const std::string why = confirmed ? confirmed->doubt : result.failure; !why.empty()) {
        tell(why, springRed);
        frame.say(why);
    } else if (confirmed) {
        tell(formatted("confirmed: by a tenth of the tolerance no component differs by more than %.1e of its size",
                       confirmed->difference),
             springInk);
    }
}

}  // namespace mv::springs
