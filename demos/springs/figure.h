// Pictures of masses on springs: the masses, their energy over time, and the region where a method is stable.
#pragma once
#include <complex>
#include <span>
#include <string>
#include <vector>

#include "game.h"
#include "mv/gl/drawing.h"
#include "mv/motion/ode_method.h"

namespace mv {

inline const vec4 springRed(0.75, 0.15, 0.1, 1), springBlue(0.1, 0.3, 0.7, 1), springGrey(0.6, 0.6, 0.6, 1),
    springInk(0.1, 0.1, 0.1, 1), springHand(0.85, 0.55, 0.1, 1);

// The pixel of a place of the scene in its pane, seen from a little above and from the left.
vec2 springPixel(const Pane& pane, const vec3& place);

// Masses, springs coloured by their stretch, and the hand. Masses more than 100 m away are left out; returns how many
// that are.
int drawSprings(Drawing& drawing, const Pane& pane, const SpringSetup& setup, std::span<const double> state);

// The one spring's place (across) and speed (upwards), in units of its first swing: two hands, which turn.
void drawPhase(Drawing& drawing, const Pane& pane, const SpringGame& game);

// The last ten seconds of energy and balance, and a line where the balance ought to stay.
void drawEnergy(Drawing& drawing, const Pane& pane, const SpringGame& game);

// A pane's frame for numbers z = step x eigenvalue, in which all of these have room.
Plot stabilityPlot(const Pane& pane, std::span<const std::complex<double>> numbers);
// For that frame, over it a grid of what the method makes of a number z: its position is Re z, Im z and g, where a step
// multiplies by (1 + g)/(1 - g). So g is 0 where nothing grows or shrinks, and 1 at a pole.
MeshData stabilityGrid(OdeMethod method, const Plot& plot);

// A line of words whose size suits the pane; and words as lines of at most so many letters, where a word is not longer.
void paneWords(Drawing& drawing, const Pane& pane, const vec2& at, const std::string& text, const vec4& color);
std::vector<std::string> wrapped(const std::string& text, std::size_t width);

}  // namespace mv
