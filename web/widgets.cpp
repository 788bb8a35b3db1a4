#include "widgets.h"

#include "mv/demo/demo.h"

namespace mv {
namespace {

void addWidget(JsonText& json, const Knob& knob) {
    const auto number = [&](bool whole) {
        const NumberRange range = knob.numbers();
        json.add("low", range.low).add("high", range.high).add("whole", whole);
        json.add("logarithmic", range.scale == Scale::logarithmic).add("orZero", range.orZero).add("kind", "number");
    };
    switch (knob.kind()) {
        case Knob::Kind::number:
        case Knob::Kind::angle:
            return number(false);
        case Knob::Kind::whole:
            return number(true);
        case Knob::Kind::toggle:
            json.add("kind", "switch");
            return;
        case Knob::Kind::word:
        case Knob::Kind::oneOf:
            json.array("options");
            for (const Option& option : knob.options())
                json.object().add("word", option.word).add("meaning", option.meaning).end();
            json.end().add("kind", "choice");
            return;
        case Knob::Kind::file:
            json.add("accept", knob.endings()).add("kind", "file");
            return;
        case Knob::Kind::points:
            json.add("kind", "words");
            if (knob.isFixedNumber()) return;
            json.array("buttons");
            json.object().add("label", "+").add("enabled", knob.canAddPoint()).end();
            json.object().add("label", "-").add("enabled", knob.canRemovePoint()).end();
            json.end();
            return;
    }
}

}  // namespace

void addWidgets(JsonText& json, const Demo& demo) {
    for (const Knob* knob : demo.knobs()) {
        json.object(knob->name());
        addWidget(json, *knob);
        json.end();
    }
}

bool pressButton(Knob& knob, const std::string& label) {
    const std::size_t last = knob.points().size() - 1;
    return label == "+" ? knob.addPoint(last) : knob.removePoint(last);
}

}  // namespace mv
