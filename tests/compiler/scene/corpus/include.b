#include "fuzz.b"
#include
#include "