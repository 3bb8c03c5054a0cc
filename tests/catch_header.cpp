// What aspect_catch_header precompiles for all tests.
#include <catch2/catch.hpp>
