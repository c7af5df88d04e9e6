# The program in the README is the one that the other package tests build.
file(READ ${SOURCE}/README.md readme)
file(READ ${CONSUMER}/program.cpp program)
string(FIND "${readme}" "```cpp\n${program}```" place)
if(place LESS 0)
  message(FATAL_ERROR "README.md does not show tests/package/program.cpp as it is")
endif()
