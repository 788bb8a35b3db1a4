// A quantity of each pixel of a picture, below 0 where none is seen: what studies and probes compare.
#pragma once
#include <optional>
#include <vector>

namespace mv {

// For Reference::regions: 0 where the quantity is seen, and else -1.
std::vector<int> regionsOfSeen(const std::vector<double>& values);

// The root mean square of the difference over the pixels where both are seen; none where there is no such pixel. Error: the numbers of
// pixels differ.
std::optional<double> rmsBetween(const std::vector<double>& a, const std::vector<double>& b);
// As the number of a probe: of the pixels that Probing::measured() has, against the exact ones.
std::vector<double> rmsOfShown(const std::vector<float>& shown, const std::vector<double>& exact);

}  // namespace mv
