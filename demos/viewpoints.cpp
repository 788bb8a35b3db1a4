// viewpoints: a car on a round track, seen from nine places, each by one lookAt and an order of matrices.
//
// Claims (each is a test in tests/claims/viewpoints.cpp):
// - [eight-views] Views 1 to 8 have the matrices of the WebGL page, to rounding, all the lap round.
// - [car-faces-ahead] The car points where it drives; the slide's sign would turn it away by twice its direction.
// - [what-stands-still] From outside the car the scenery stands still in the picture, from inside the car does.
// - [lap-of-120] A lap is 120 pictures, each another one, and then begins again.
// - [slide-misses-house] View 5 by the slide's formula misses the house and tilts the horizon, the more the higher.
// - [exact-hits-house] View 5 with eye and target taken to world space has the house in the middle, horizon level.
// - [down-needs-another-up] Straight down, up = z is refused; up = y puts +y at the top and +x to the right.
// - [eye-under-the-roof] In views 4 and 5 a height that puts the eye under the car's roof is refused.
#include <cmath>

#include "mv/demo/demo.h"
#include "mv/geometry/in_view.h"
#include "mv/geometry/shapes.h"
#include "mv/gl/gl.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"
#include "shared/car.h"

using namespace mv;

namespace {

enum class View { distant, inside, outside, driver, house, behind, front, beside, above };

struct House {
    double x, y, size;
};
constexpr House houses[] = {{-20, 50, 5},  {0, 70, 10},   {20, -10, 8}, {40, 120, 10},
                            {-30, -50, 7}, {10, -60, 10}, {-20, 75, 8}, {-40, 140, 10}};

struct Viewpoints final : Demo {
    Choice<View> view{this,
                      "view",
                      View::distant,
                      {{"1", "from a distance"},
                       {"2", "at the car from inside the ring"},
                       {"3", "at the car from outside the ring"},
                       {"4", "the driver's"},
                       {"5", "out of the car, always at one house"},
                       {"6", "from behind and above the car"},
                       {"7", "back from a car in front"},
                       {"8", "from beside the car"},
                       {"9", "straight down at the middle of the track"}},
                      "where the eye is"};
    Real height{this, "height", 0, {-4, 100}, "how much higher the eye is than the view says"};
    Toggle exact{this, "exact", false, "view 5: one lookAt in world space instead of the slide's formula"};
    Real aim{this, "aim", 0, {0, 10}, "view 5: how high on the house to look; at height 0, 5 is level"};

    Readout direction{this, "direction", "how far the car has come, clockwise from +y", "deg"};
    Readout eyeHeight{this, "eye-height", "how high the eye is above the ground"};
    Readout miss{this, "miss", "view 5: angle between the line of sight and the house", "deg"};
    Readout roll{this, "roll", "view 5: how far the horizon is tilted", "deg"};

    Program program;
    MeshData plainCube = colorCube();
    Mesh track, cube;

    Viewpoints() {
        for (char digit = '1'; digit <= '9'; ++digit) bindKey(key(digit), view, std::string(1, digit));
        bindKeys(Key::down, Key::up, height, 2);
        for (Knob* knob : std::initializer_list<Knob*>{&exact, &aim}) {
            knob->onlyWhen([this] { return view == View::house; }, "only view 5 looks at a house");
        }
    }

    void init() override {
        program = Program("viewpoints");
        track = Mesh(ringStrip(90, 110, 100), "track");
        plainCube.colors.clear();  // each thing here has one colour, a uniform
        cube = Mesh(plainCube, "cube");
    }

    void draw(const Frame& frame) override {
        glEnable(GL_DEPTH_TEST);

        // Drive: clockwise seen from above, 3 degrees a frame
        const double d = 3.0 * (frame.index() % 120);
        const vec3 car(100 * std::sin(radians(d)), 100 * std::cos(radians(d)), 0);
        const mat4 worldFromCar = translate(car) * rotateZ(-d);
        const mat4 carFromWorld = rotateZ(d) * translate(-car);

        // Look: lookAt speaks of the world, and the car is put into it, or of the car, and the world is put around it
        const bool ofWorld = view <= View::outside || view == View::above || (view == View::house && exact);
        const mat4 look = lookFrom(car, d, worldFromCar);
        const mat4 viewFromWorld = ofWorld ? look : look * carFromWorld;
        const mat4 viewFromCar = ofWorld ? look * worldFromCar : look;
        const mat4 clipFromView = perspective(50, frame.aspect(), 1, 500);
        frame.show("viewFromWorld", viewFromWorld);
        frame.show("viewFromCar", viewFromCar);
        frame.show("clipFromView", clipFromView);

        // Draw, in the order in which the matrices come about; the depth test makes any order do
        program.use();
        program.set("clipFromView", clipFromView);
        if (ofWorld) drawScenery(clipFromView, viewFromWorld);
        drawCar(viewFromCar);
        if (!ofWorld) drawScenery(clipFromView, viewFromWorld);

        direction = d;
        measure(inverse(viewFromWorld), vec3(40, 120, aim));
    }

    void check() const override {
        // Below the roof these views can show nothing but the car's own blue.
        if ((view == View::driver || view == View::house) && height < -1)
            throw Error("--height", "must be at least -1 in views 4 and 5: the eye is under the car's roof",
                        height.text());
    }

    mat4 lookFrom(const vec3& car, double d, const mat4& worldFromCar) const {
        const vec3 up(0, 0, 1), house(40, 120, aim);
        switch (view) {
            case View::distant:
                return lookAt(vec3(250, 0, 100 + height), vec3(0, 0, 0), up);
            case View::inside:
                return lookAt(vec3(75, 0, 5 + height), car, up);
            case View::outside:
                return lookAt(vec3(125, 0, 5 + height), car, up);
            case View::driver:
                return lookAt(vec3(-3, 0, 5 + height), vec3(12, 0, 2 + height), up);
            case View::house:
                if (exact) return lookAt(vec3(worldFromCar * vec4(3, 0, 5 + height, 1)), house, up);
                return rotateY(-d) * lookAt(vec3(3, 0, 5 + height), house - car, up);
            case View::behind:
                return lookAt(vec3(-12, 0, 6 + height), vec3(15, 0, 4), up);
            case View::front:
                return lookAt(vec3(25, 5, 5 + height), vec3(0, 0, 2), up);
            case View::beside:
                return lookAt(vec3(2, 20, 5 + height), vec3(2, 0, 2), up);
            case View::above:
                break;
        }
        return lookAt(vec3(0, 0, 200 + height), vec3(0, 0, 0), vec3(0, 1, 0));  // looks along z: up must be another
    }

    void drawScenery(const mat4& clipFromView, const mat4& viewFromWorld) {
        program.set("paint", vec4(0.4, 0.4, 0.4, 1));
        program.set("viewFromModel", viewFromWorld);
        track.draw();
        program.set("paint", vec4(1, 0, 0, 1));
        for (const auto& [x, y, size] : houses) {
            const mat4 viewFromHouse = viewFromWorld * translate(x, y, size / 2) * scale(size);
            if (!isInView(plainCube, clipFromView * viewFromHouse)) continue;
            program.set("viewFromModel", viewFromHouse);
            cube.draw();
        }
    }

    void drawCar(const mat4& viewFromCar) {
        program.set("paint", vec4(0, 0, 1, 1));
        for (const mat4& carFromCube : carFromCubes()) {
            program.set("viewFromModel", viewFromCar * carFromCube);
            cube.draw();
        }
    }

    // From the matrix that was used, whichever way it was made: its inverse has the eye's place and axes as columns.
    void measure(const mat4& worldFromView, const vec3& house) {
        const vec3 eye(worldFromView[3]), right(worldFromView[0]), upwards(worldFromView[1]), ahead(-worldFromView[2]);
        eyeHeight = eye.z;
        if (view != View::house) return;
        const vec3 wanted = house - eye;
        miss = degrees(std::atan2(length(cross(ahead, wanted)), dot(ahead, wanted)));
        roll = degrees(std::abs(std::atan2(right.z, upwards.z)));
    }
};

constexpr Declaration declaration{
    .name = "viewpoints",
    .sentence = "One lookAt for each view: what it speaks of, and in which order the matrices are multiplied.",
    .lookFor = "In views 1 to 3 and 9 the car moves; in 4 to 8 the car stands still and the world moves around it.",
    .chapter = "Viewing and projection",
    .number = 1,
    .width = 700,
    .height = 700,
    .animated = true,
    .background = vec4(0.7, 1.0, 0.7, 1.0),
    .needs = {.depth = true},
    .presets =
        {
            {"original", "The car goes round clockwise; track and houses stand still."},
            {"driver", "Now the car stands still, and the world turns around it.", {{"view", "4"}}},
            {"beside", "The same from beside it: the road runs away underneath.", {{"view", "8"}}},
            {"house-by-slide",
             "Looking at one house from the moving car, by the slide's formula: houses and track lean over.",
             {{"view", "5"}, {"height", "40"}}},
            {"house-exact",
             "The same view with eye and house in one space: they stand upright; roll and miss are 0.",
             {{"view", "5"}, {"height", "40"}, {"exact", "on"}},
             {{"roll", 0, 1e-9}, {"miss", 0, 1e-9}}},
            {"above",
             "Straight down. Up along the gaze says nothing, so +y is up here.",
             {{"view", "9"}, {"height", "40"}}},
        },
    .waste = {{"no-sample", "draw of 'cube'", "what hides it is known when it is drawn"},
              {"outside-view", "draw of 'cube'", "a scene of a few cubes is drawn sooner than asked for"}},
};

const bool added = addDemo<Viewpoints, declaration>();

}  // namespace
