# Precompiled headers: most of the time of a build goes into reading the standard library and Boost.Multiprecision. They save
# time alone: every file includes what it uses, and the preset `fuzz`, which has none, shows that it does. Not CLI11, which is compiled
# with every file that sees it.
set(strata_common_headers
  <algorithm> <array> <bit> <cmath> <cstddef> <cstdint> <exception> <filesystem> <functional> <limits> <map> <memory>
  <numeric> <optional> <set> <span> <stdexcept> <string> <string_view> <unordered_map> <utility> <vector>)
if(STRATA_WITH_GMP)
  list(APPEND strata_common_headers <boost/multiprecision/gmp.hpp>)
else()
  list(APPEND strata_common_headers <boost/multiprecision/cpp_int.hpp>)
endif()

# GCC 12 sees writes beyond the ends of strings in the standard library once its headers are precompiled.
set(strata_precompiled_options "$<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds;-Wno-stringop-overflow;-Wno-restrict>")

# strata_precompile(TARGET [HEADERS...]): the common headers and these.
function(strata_precompile target)
  if(STRATA_PRECOMPILED)
    target_compile_options(${target} PRIVATE ${strata_precompiled_options})
    target_precompile_headers(${target} PRIVATE ${strata_common_headers} ${ARGN})
  endif()
endfunction()

# Those of another target, which must be compiled in the same way.
function(strata_precompile_as target other)
  if(STRATA_PRECOMPILED)
    target_compile_options(${target} PRIVATE ${strata_precompiled_options})
    target_precompile_headers(${target} REUSE_FROM ${other})
  endif()
endfunction()
