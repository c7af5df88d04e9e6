#include "run_command.h"
#include "suite.h"

int main(int argc, char** argv) {
  if (argc > 1 && is_suite_verb(argv[1])) return become_suite(argv);
  return run_command(argc, argv);
}
