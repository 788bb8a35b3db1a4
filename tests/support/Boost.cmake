# mvgl-boost: Boost's headers, and GNU MPFR, by which Boost.Multiprecision computes with 34 and 50 digits in half of the time that its
# own form of them takes.
if(NOT TARGET mvgl-boost)
  find_path(BOOST_INCLUDE_DIR boost/multiprecision/mpfr.hpp REQUIRED DOC "Reference values (package libboost-dev)")
  find_path(MPFR_INCLUDE_DIR mpfr.h REQUIRED DOC "Reference values (package libmpfr-dev)")
  find_library(MPFR_LIBRARY mpfr REQUIRED DOC "Reference values (package libmpfr-dev)")
  find_library(GMP_LIBRARY gmp REQUIRED DOC "What MPFR computes by (package libgmp-dev)")
  add_library(mvgl-boost INTERFACE)
  target_include_directories(mvgl-boost SYSTEM INTERFACE "${BOOST_INCLUDE_DIR}" "${MPFR_INCLUDE_DIR}")
  target_link_libraries(mvgl-boost INTERFACE "${MPFR_LIBRARY}" "${GMP_LIBRARY}")
endif()
