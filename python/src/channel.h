#pragma once
/// Channels of attributes between NumPy and the library.
#include <nanobind/nanobind.h>
#include <strata/attributes.h>

#include <cstddef>
#include <string>

#include "names.h"

namespace strata::python {

/// Of an array of shape (n,) or (n, k), whose numbers are copied; without an interpolation with the usual one. Throws
/// TypeError and ValueError with the name of the channel.
[[nodiscard]] Channel channel_of(std::string name, nb::handle values, Element element,
                                 const InterpolationName& interpolation);

/// The channel of an object of Python. Throws TypeError for others.
[[nodiscard]] const Channel& channel_in(nb::handle object);

/// An array over memory that `owner` keeps.
[[nodiscard]] nb::object array_of(const Channel& channel, nb::handle owner);

/// As "(8, 3) float32 per vertex".
[[nodiscard]] std::string describe_values(const Channel& channel);

/// Throws std::invalid_argument where attributes fit no mesh: the first channel on vertices, and the first on others,
/// say how many there are.
void check_alone(const Attributes& attributes);

}  // namespace strata::python
