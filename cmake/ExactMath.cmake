# mvgl_refuse_inexact_math(): refuses compiler flags that let the compiler change what numbers come out: sums in another
# order, NaN that is none. Exact predicates, the refusal of NaN and sixty tests rely on them.
function(mvgl_refuse_inexact_math)
  get_property(add_compile_options DIRECTORY PROPERTY COMPILE_OPTIONS)
  set(places CMAKE_CXX_FLAGS add_compile_options)
  foreach(configuration IN LISTS CMAKE_BUILD_TYPE CMAKE_CONFIGURATION_TYPES)
    string(TOUPPER "CMAKE_CXX_FLAGS_${configuration}" place)
    list(APPEND places ${place})
  endforeach()
  foreach(place IN LISTS places)
    string(REPLACE " " ";" flags "${${place}}")
    foreach(flag IN LISTS flags)
      if(flag MATCHES "^-(ffast-math|Ofast|funsafe-math-optimizations|fassociative-math|freciprocal-math|ffinite-math-only)$"
         OR flag MATCHES "^-(ffp-model=(fast|aggressive)|ffp-contract=fast)$")
        message(FATAL_ERROR "${place}: must not have a flag that changes what is computed; take it out, ${flag}")
      endif()
    endforeach()
  endforeach()
endfunction()
