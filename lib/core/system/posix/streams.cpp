#include "core/system/streams.h"

#include <fcntl.h>
#include <poll.h>
#include <stdlib.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>

namespace strata::system {

bool wait_to_read(int descriptor, int milliseconds) {
  pollfd ready = {descriptor, POLLIN, 0};
  const int seen = ::poll(&ready, 1, milliseconds);
  return seen > 0 || (seen < 0 && errno != EINTR);
}

bool is_terminal(int descriptor) { return ::isatty(descriptor) == 1; }

void use_binary_streams() {}

std::filesystem::path make_scratch_folder() {
  namespace fs = std::filesystem;
  std::string name = (fs::temp_directory_path() / "strata-XXXXXX").string();  // mkdtemp fills the end in
  if (::mkdtemp(name.data()) == nullptr)
    throw fs::filesystem_error("no folder for temporary files", name, {errno, std::generic_category()});
  return name;
}

int duplicate(int descriptor) { return ::fcntl(descriptor, F_DUPFD_CLOEXEC, standard_error + 1); }

}  // namespace strata::system
