// motion/two_link.h.
#include <algorithm>

#include "accuracy/function.h"
#include "mv/motion/two_link.h"

namespace mv::accuracy {
namespace {

// Two lengths, up to 1e6 times as long as each other, and room for what else there is.
Arguments links(Random& random, Domain domain) {
    const double scale = anyScale(random, domain, 150), apart = domain == Domain::whole ? 1e3 : 3;
    return {scale * random.logarithmic(1 / apart, apart), scale * random.logarithmic(1 / apart, apart)};
}

// These and two angles of up to a thousand turns.
Arguments linksWithAngles(Random& random, Domain domain) {
    Arguments a = links(random, domain);
    const double most = domain == Domain::whole ? 3.6e5 : 180;
    for (const std::size_t i : {2U, 3U}) a[i] = random.number(-most, most);
    return a;
}

// These and a target, half of them within 1e-17 to 1 of the way between the bounds of the reach from either bound.
Arguments linksWithTarget(Random& random, Domain domain) {
    Arguments a = links(random, domain);
    const double reach = a[0] + a[1], hole = std::abs(a[0] - a[1]), direction = random.number(-pi, pi);
    const double part = domain == Domain::whole ? random.logarithmic(1e-17, 1) : random.number(0, 1);
    const double play = random.sign() * part * (reach - hole), bound = random.sign() < 0 ? reach : hole;
    const double distance = std::abs(bound + play);
    a[2] = distance * std::cos(direction);
    a[3] = distance * std::sin(direction);
    return a;
}

std::vector<Wide> endOf(const Wide& l1, const Wide& l2, double shoulder, double elbow) {
    const Wide a = reducedRadians(shoulder), b = a + reducedRadians(elbow);
    return {l1 * cos(a) + l2 * cos(b), l1 * sin(a) + l2 * sin(b)};
}

Truth ofReach(const Arguments& a, std::vector<Wide> values) {
    Truth truth = entrywise(std::move(values));
    truth.sizes.assign(truth.values.size(), sizeOf(Wide(a[0]) + a[1]));
    return truth;
}

// The target, or the point of the reach that is nearest to it: for either solution.
Truth nearestPoint(const Arguments& a) {
    const Wide x = a[2], y = a[3], distance = sqrt(x * x + y * y), l1 = a[0], l2 = a[1];
    const Wide nearest = std::min<Wide>(std::max<Wide>(distance, abs(l1 - l2)), l1 + l2);
    const Wide pointX = distance == 0 ? nearest : x * nearest / distance,
               pointY = distance == 0 ? 0 : y * nearest / distance;
    return ofReach(a, {pointX, pointY, pointX, pointY});
}

}  // namespace

std::vector<Function> twoLinkFunctions() {
    std::vector<Function> list;
    list.push_back(withForms(
        {.name = "twoLinkEnd",
         .header = "two_link.h",
         .returns = "where the second of two links ends",
         .measured = "ulp of l1 + l2",
         .domain = "lengths 1e-150 to 1e150, up to 1e6 apart, up to 1000 turns",
         .bound = 12,
         .reason =
             "an ulp of 180 degrees is one of pi, which is up to 4 of the reach; a sum of angles and its radians have "
             "three such roundings",
         .sample = linksWithAngles,
         .truth = [](const Arguments& a) { return ofReach(a, endOf(a[0], a[1], a[2], a[3])); },
         .limits = "lengths 0, or from 1e-290 to 1e290",
         .within =
             [](const Arguments& a) {
                 return sizesBetween(1e-290, 1e290)({a[0], a[1]}) && a[0] >= 0 && a[1] >= 0;
             }},
        [](const Arguments& a) {
            return twoLinkEnd(a[0], a[1], {a[2], a[3]});
        }));

    Function inverse = withForms(
        {.name = "twoLinkAngles",
         .header = "two_link.h",
         .returns = "the angles of two links whose end is at a target",
         .measured = "how far the end is from the target, or from the nearest point of the reach, ulp of l1 + l2",
         .domain = "lengths 1e-150 to 1e150, up to 1e6 apart, as near to the bounds of the reach as 1e-17",
         .bound = 24,
         .reason = "as twoLinkEnd, and two arcs of up to pi, their difference, and both angles in degrees",
         .sample = linksWithTarget,
         .truth = nearestPoint,
         .limits = "numbers 0, or from 1e-290 to 1e290 in size; lengths not below 0",
         .within =
             [sizes = sizesBetween(1e-290, 1e290)](const Arguments& a) { return sizes(a) && a[0] >= 0 && a[1] >= 0; }},
        [](const Arguments& a) {
            const TwoLinkAnswer answer = twoLinkAngles(a[0], a[1], {a[2], a[3]});
            return std::array<vec2, 2>{vec2(answer.angles[0].shoulder, answer.angles[0].elbow),
                                       vec2(answer.angles[1].shoulder, answer.angles[1].elbow)};
        });
    // The angles themselves are as uncertain as the target is near a bound; what they are for is the end.
    inverse.forms[0].values = [angles = inverse.forms[0].values](const Arguments& a) {
        const std::vector<Wide> four = angles(a);
        std::vector<Wide> ends;
        for (const std::size_t i : {0U, 2U}) {
            for (const Wide& value :
                 endOf(a[0], a[1], static_cast<double>(four[i]), static_cast<double>(four[i + 1]))) {
                ends.push_back(value);
            }
        }
        return ends;
    };
    list.push_back(inverse);
    return list;
}

}  // namespace mv::accuracy
