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
  /// What was written since the last call, as captured_text() gives it.
  [[nodiscard]] std::string take() const;
  void clear() const;  ///< forgets what was written

 private:
  int descriptor_ = -1;
};
