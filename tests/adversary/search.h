// A search for the arguments on which a function is worst: random samples, and from each of them a climb that changes bits.
#pragma once
#include <cstdint>
#include <vector>

#include "accuracy/function.h"

namespace mv::adversary {

using accuracy::Arguments;
using accuracy::Domain;
using accuracy::Form;
using accuracy::Function;

struct Worst {
    double ulp = 0;  // infinity where a result was not finite
    Arguments input{};
    long evaluations = 0;
    long refused = 0;  // of them: by the function, or outside its limits
};

// The worst error that this many evaluations find. Climbs begin at samples of this domain, in turn with `known` inputs where
// there are any, and keep each change of one or two arguments after which the error is not smaller (where the errors are
// equal: after which the other verdict is not farther away). A climb that has not risen for some hundred changes ends.
// The same seed gives the same result on the same machine.
Worst search(const Function& function, const Form& form, Domain startsFrom, std::uint64_t seed, long evaluations,
             const std::vector<Arguments>& known = {});

// The indices of the arguments that the function reads, as far as its samples tell: those that ever differ from 0.
std::vector<std::size_t> usedArguments(const Function& function);

}  // namespace mv::adversary
