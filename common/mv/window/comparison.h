// Two settings of one knob in one picture: a divider between them, one of them alone, or where they differ.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "mv/gl/target.h"
#include "mv/run/command_line.h"
#include "mv/run/copyable.h"
#include "mv/show/session.h"

namespace mv {

// The knob itself holds A, the present value, so that all that moves a knob moves A; B is the other value.
class Comparison final : public OtherPicture {
  public:
    enum class View { divider, a, b, difference };
    // The notes of one of the two settings.
    struct Side {
        Picture picture;
        std::vector<std::string> messages;
        std::vector<std::optional<double>> readouts;
        double milliseconds = 0;
    };

    bool on() const { return knob_ != nullptr; }
    // Compares the knob's present value with `other`. Error: a value that the knob does not take.
    void start(Knob& knob, const std::string& other);
    void stop();

    const Knob* knob() const { return knob_; }
    // Only while it is on:
    const std::string& other() const { return other_; }
    void setOther(const std::string& text) { other_ = text; }
    ComparedKnob compared() const { return {knob_->name(), other_}; }
    std::string labelA() const { return knob_->name() + " = " + knob_->text(); }
    std::string labelB() const { return knob_->name() + " = " + other_; }

    // Error: as Demo::check; where only B makes no picture the message says so.
    void check(const Demo& demo) override;
    // Draws the frame with both values. The stage ends with A's picture and notes. Error: as Stage::draw; both sides then
    // stay what they were.
    Cost draw(Stage& stage, int index, bool readouts) override;
    bool drawn() const { return on() && !a_.picture.rgba.empty(); }
    const Side& sideA() const { return a_; }
    const Side& sideB() const { return b_; }
    // The messages of either about its picture; a message of one of them alone has its setting before it.
    std::vector<std::string> messages() const;

    View view() const { return view_; }
    void setView(View view);
    // The place of the divider, 0 (left) .. 1 of the picture's width; it stops at the edges.
    double divider() const { return divider_; }
    void moveDivider(double to);
    // How far the two are apart: "difference: 2.31 % of pixels, at most 87 of 255". Both must be drawn.
    const std::string& difference();

    // The two as the view asks, with their labels. Both must be drawn.
    const Target& sheet();

  private:
    void withOther(const std::function<void()>& action);
    Side drawSide(Stage& stage, int index, bool readouts) const;
    Picture composed() const;

    TextStyle words_;
    Knob* knob_ = nullptr;
    std::string other_;
    Side a_, b_;
    std::string drawnA_, drawnB_;  // the labels of the two pictures
    std::string difference_;       // "": not known yet
    View view_ = View::divider;
    double divider_ = 0.5;
    Target sheet_;
    bool stale_ = true;  // the sheet is not what the view asks for
};

// Whether the knob can be compared: it has another value, and its values can stand in --compare KNOB=A,B.
bool canCompare(const Knob& knob);
// A value to compare the present one with: the initial one, or where it is that, one far from it.
std::string valueToCompareWith(const Knob& knob);

}  // namespace mv
