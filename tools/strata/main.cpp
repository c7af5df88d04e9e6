#include <array>
#include <string>
#include <string_view>

#include "core/system/memory.h"
#include "core/system/streams.h"
#include "run_command.h"
#include "suite.h"

int main(int argc, char** argv) {
  strata::system::use_binary_streams();
  strata::system::keep_freed_memory();
  if (argc > 1 && is_suite_verb(argv[1])) return become_suite(argv);
  if (argc > 2 && std::string_view(argv[1]) == "help" && is_suite_verb(argv[2])) {
    std::string option = "--help";
    std::array<char*, 4> words{argv[0], argv[2], option.data(), nullptr};
    return become_suite(words.data());
  }
  return run_command(argc, argv);
}
