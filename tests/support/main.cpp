// The one place where Catch2's main is compiled; every test program links this object.
#define CATCH_CONFIG_MAIN
#include <catch2/catch.hpp>

#if CATCH_VERSION_MAJOR >= 3
int main(int count, char** words) { return Catch::Session().run(count, words); }
#endif
