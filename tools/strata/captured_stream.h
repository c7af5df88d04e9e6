#pragma once
#include <string>

/// A file without a name that takes what a process writes on one of its streams. Parent and children share it.
class CapturedStream {
 public:
  CapturedStream();  ///< throws std::system_error
  ~CapturedStream();
  CapturedStream(const CapturedStream&) = delete;
  CapturedStream& operator=(const CapturedStream&) = delete;

  /// Makes it the stream (1 or 2) of this process.
  void replace(int stream) const;
  /// What was written since the last call, in UTF-8: the first and the last kilobytes of a long text, with a line
  /// "[... bytes]" in place of the rest.
  [[nodiscard]] std::string take() const;
  void clear() const;  ///< forgets what was written

 private:
  [[nodiscard]] std::string part(long long offset, long long size) const;

  int descriptor_ = -1;
};
