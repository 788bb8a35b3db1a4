// A knob that is a list of points of a plane: dragged in the picture, added and removed there.
#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "mv/demo/knob.h"
#include "mv/math/types.h"

namespace mv {

// On the command line x,y/x,y/x,y. Outside its limits, and beside its grid, a point is refused. It is dragged only where the
// demo's constructor also says where a point is in the picture:
//     Points lights{this, "lights", {{1, 2}}, {{-4, -4}, {4, 4}, 1, 8, 0.01}, "x,z of each light"};
//     bindHandle("light", lights, [this](const FrameInfo& frame, const vec2& at) { return placeOf(at, frame); });
class Points : public Knob {
  public:
    struct Limits {
        vec2 low, high;
        std::size_t least, most;  // points
        double grid;              // each coordinate is a multiple of this
    };
    Points(Demo* owner, Literal name, std::vector<vec2> initial, Limits limits, Literal help, Literal unit = "");

    std::size_t size() const { return points().size(); }
    const vec2& operator[](std::size_t i) const { return points()[i]; }
    const std::vector<vec2>& points() const {
        noteRead();
        return points_;
    }

    std::string text() const override { return textOf(points()); }
    void parse(std::string_view text) override;
    std::string initialText() const override { return textOf(initial_); }
    std::string range() const override;
    // As few points as there may be, in the low corner; the initial ones; and as many as there may be, from corner to
    // corner.
    std::vector<std::string> sweep() const override;
    // Moves all of them along x.
    bool step(double amount) override;
    bool widget(Panel& panel) override;

    // x (0) or y (1) of a point, for a handle.
    Coordinate coordinate(std::size_t point, int axis);
    // Whether there are always as many.
    bool isFixedNumber() const { return limits_.least == limits_.most; }
    // One more after that one, at the same place, or one less; false where there are as many, or as few, as there may be.
    bool add(std::size_t after);
    bool remove(std::size_t point);

  private:
    static std::string textOf(const std::vector<vec2>& points);
    // The nearest that is allowed.
    double onGrid(double value, int axis) const;

    std::vector<vec2> points_, initial_;
    Limits limits_;
};

}  // namespace mv
