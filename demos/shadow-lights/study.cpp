// The study of shadow-lights: which part of the lights reaches each pixel, against rays.
#include <numeric>
#include <string>
#include <vector>

#include "mv/demo/demo.h"
#include "shared/lit_reference.h"

using namespace mv::claims;

namespace mv::shadow_lights {
namespace {

Study study() {
    Study study;
    study.quantity = "mean over the lights of lit or not, of the pixels that face the first";
    study.reference = "one ray through each pixel and one to each light, in double precision";
    study.makeReference = [](const Demo& demo, const ReferenceFrame& frame, const auto& progress) {
        const Scene scene = demo.scene(frame);
        std::vector<int> all(scene.lights.size());
        std::iota(all.begin(), all.end(), 0);
        return litReference(scene, frame, {.lights = all}, progress);
    };
    study.reads = {"scene", "lights", "places", "spin-x", "spin-y", "distance"};
    study.problem = "lights";
    study.scenes = {{"circle", {{"scene", "circle"}}}, {"lamps", {{"scene", "lamps"}}}};
    const std::vector<std::string> counts{"1", "2", "4", "8"}, sizes{"256", "512", "1024", "2048"};
    study.lines = {{"volumes, by lights", {{"method", "volumes"}, {"keep", "off"}}, "lights", counts, {"circle"}},
                   {"maps, by lights", {{"method", "maps"}, {"keep", "off"}}, "lights", counts, {"circle"}},
                   {"maps, by resolution", {{"method", "maps"}, {"keep", "off"}}, "resolution", sizes}};
    study.axis = ErrorAxis::fraction;
    study.wrongBeyond = 0.05;  // less than one light of eight
    const auto volumes = rows("volumes, by lights"), maps = rows("maps, by lights");
    study.says = {
        claim("a-share-for-each",
              "Beside the frame's own cost, of six draws, each light costs eleven: eight lights draw 5.53 times as "
              "much as one, by maps and by volumes, and take three to seven times as long.",
              {ratio(of::count("draws"), volumes.at(8), volumes.at(1), 5.525, 5.535),
               ratio(of::count("draws"), maps.at(8), maps.at(1), 5.525, 5.535),
               ratio(of::time, volumes.at(8), volumes.at(1), 3, 7), ratio(of::time, maps.at(8), maps.at(1), 3, 7)}),
        claim("volumes-exact",
              "By volumes no pixel away from edges is wrong with one, two, four or eight lights, and at most nine "
              "of 302 000 at edges.",
              {atMost(of::wrong, volumes, 0.003), zero(of::wrongAwayFromEdges, volumes)}),
        claim("half-for-twice", "Of maps about half as many pixels are wrong when they are twice as large.",
              {slope(of::wrong, rows("maps, by resolution"), -1.1, -0.85)}),
        claim("edges-of-each",
              "Each light has edges of its own to be wrong at: by maps the wrong pixels are as many times more as "
              "the lights are.",
              {slope(of::wrong, maps, 0.9, 1.1)})};
    return study;
}

const bool studied = addStudy("shadow-lights", study());

}  // namespace
}  // namespace mv::shadow_lights
