#pragma once
#include <stdexcept>

/// The options make no sense together.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};
