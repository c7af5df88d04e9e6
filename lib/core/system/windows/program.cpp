#include "core/system/program.h"

#include <cerrno>
#include <cstdio>
#include <cstdlib>

#include "core/system/windows/api.h"

namespace strata::system {

namespace fs = std::filesystem;

const char path_separator = ';';
const char* const program_suffix = ".exe";

fs::path own_program() {
  std::wstring name(std::size_t{1} << 15, L'\0');
  name.resize(::GetModuleFileNameW(nullptr, name.data(), static_cast<DWORD>(name.size())));
  return name;
}

std::uint64_t process_number() { return ::GetCurrentProcessId(); }

bool is_program(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

namespace {

/// A word as the C library of a program reads it back: in quotes, quotes and the backslashes before them escaped.
std::string quoted(const std::string& word) {
  if (!word.empty() && word.find_first_of(" \t\n\v\"") == std::string::npos) return word;
  std::string text = "\"";
  std::size_t backslashes = 0;
  for (const char c : word) {
    if (c == '"') text.append(backslashes + 1, '\\');
    backslashes = c == '\\' ? backslashes + 1 : 0;
    text += c;
  }
  return text.append(backslashes, '\\') + "\"";
}

std::wstring command_line(const std::vector<std::string>& words) {
  std::string line;
  for (const std::string& word : words) line.append(line.empty() ? "" : " ").append(quoted(word));
  return wide(line);
}

/// A stream of a program that is started: a file, or nothing. The program inherits it.
OwnedHandle stream_to(const fs::path& file, DWORD access) {
  SECURITY_ATTRIBUTES inherited = {sizeof inherited, nullptr, TRUE};
  const bool nowhere = file.empty();
  return OwnedHandle(::CreateFileW(nowhere ? L"NUL" : file.c_str(), access, FILE_SHARE_READ | FILE_SHARE_WRITE,
                                   &inherited, nowhere ? OPEN_EXISTING : CREATE_ALWAYS, FILE_ATTRIBUTE_NORMAL,
                                   nullptr));
}

/// The handles that a process inherits: these alone, since another thread may start one at the same time.
class Inherited {
 public:
  explicit Inherited(std::vector<HANDLE> handles) : handles_(std::move(handles)) {
    SIZE_T size = 0;
    ::InitializeProcThreadAttributeList(nullptr, 1, 0, &size);
    bytes_.resize(size);
    if (::InitializeProcThreadAttributeList(list(), 1, 0, &size) == 0 ||
        ::UpdateProcThreadAttribute(list(), 0, PROC_THREAD_ATTRIBUTE_HANDLE_LIST, handles_.data(),
                                    handles_.size() * sizeof(HANDLE), nullptr, nullptr) == 0)
      fail("cannot start a process");
  }
  ~Inherited() { ::DeleteProcThreadAttributeList(list()); }
  Inherited(const Inherited&) = delete;
  Inherited& operator=(const Inherited&) = delete;
  [[nodiscard]] LPPROC_THREAD_ATTRIBUTE_LIST list() {
    return reinterpret_cast<LPPROC_THREAD_ATTRIBUTE_LIST>(bytes_.data());
  }

 private:
  std::vector<HANDLE> handles_;
  std::vector<char> bytes_;
};

/// A group of processes that ends when the handle is closed, with the limits of a command.
OwnedHandle make_job(const Command& command) {
  OwnedHandle job(::CreateJobObjectW(nullptr, nullptr));
  JOBOBJECT_EXTENDED_LIMIT_INFORMATION limits = {};
  limits.BasicLimitInformation.LimitFlags =
      JOB_OBJECT_LIMIT_KILL_ON_JOB_CLOSE | JOB_OBJECT_LIMIT_DIE_ON_UNHANDLED_EXCEPTION;
  if (command.seconds > 0) {
    constexpr double ticks_per_second = 1e7;
    limits.BasicLimitInformation.LimitFlags |= JOB_OBJECT_LIMIT_PROCESS_TIME;
    limits.BasicLimitInformation.PerProcessUserTimeLimit.QuadPart =
        static_cast<LONGLONG>(command.seconds * ticks_per_second);
  }
  if (command.bytes > 0) {
    limits.BasicLimitInformation.LimitFlags |= JOB_OBJECT_LIMIT_PROCESS_MEMORY;
    limits.ProcessMemoryLimit = command.bytes;
  }
  if (!job.is_open() ||
      ::SetInformationJobObject(job.get(), JobObjectExtendedLimitInformation, &limits, sizeof limits) == 0)
    fail("cannot start a process");
  return job;
}

}  // namespace

struct Process::Handle {
  explicit Handle(const Command& command) : job(make_job(command)) {}
  OwnedHandle job;
  PROCESS_INFORMATION process = {};
  std::optional<ProcessEnd> end;

  bool take(DWORD milliseconds) {
    if (end) return true;
    if (::WaitForSingleObject(process.hProcess, milliseconds) != WAIT_OBJECT_0) return false;
    DWORD code = 0;
    ::GetExitCodeProcess(process.hProcess, &code);
    JOBOBJECT_EXTENDED_LIMIT_INFORMATION used = {};
    ::QueryInformationJobObject(job.get(), JobObjectExtendedLimitInformation, &used, sizeof used, nullptr);
    constexpr DWORD first_exception = 0x80000000;
    end = ProcessEnd{code >= first_exception, static_cast<int>(code), used.PeakProcessMemoryUsed};
    ::TerminateJobObject(job.get(), 1);  // whatever it has left behind
    close();
    return true;
  }
  void close() {
    if (process.hProcess != nullptr) ::CloseHandle(process.hProcess);
    if (process.hThread != nullptr) ::CloseHandle(process.hThread);
    process = {};
  }
};

Process::Process(const Command& command) : handle_(std::make_unique<Handle>(command)) {
  const OwnedHandle input = stream_to({}, GENERIC_READ), output = stream_to(command.output, GENERIC_WRITE);
  const bool is_shared = !command.error.empty() && command.error == command.output;
  const OwnedHandle own_error = is_shared ? OwnedHandle() : stream_to(command.error, GENERIC_WRITE);
  const HANDLE error = is_shared ? output.get() : own_error.get();
  std::vector<HANDLE> streams = {input.get(), output.get()};
  if (!is_shared) streams.push_back(error);
  Inherited inherited(streams);
  STARTUPINFOEXW start = {};
  start.StartupInfo.cb = sizeof start;
  start.StartupInfo.dwFlags = STARTF_USESTDHANDLES;
  start.StartupInfo.hStdInput = input.get();
  start.StartupInfo.hStdOutput = output.get();
  start.StartupInfo.hStdError = error;
  start.lpAttributeList = inherited.list();
  std::wstring line = command_line(command.words);
  const DWORD flags = CREATE_SUSPENDED | CREATE_NEW_PROCESS_GROUP | EXTENDED_STARTUPINFO_PRESENT;
  PROCESS_INFORMATION& process = handle_->process;
  if (::CreateProcessW(nullptr, line.data(), nullptr, nullptr, TRUE, flags, nullptr,
                       command.folder.empty() ? nullptr : command.folder.c_str(), &start.StartupInfo, &process) == 0) {
    const DWORD error = ::GetLastError();
    if (error != ERROR_FILE_NOT_FOUND && error != ERROR_PATH_NOT_FOUND && error != ERROR_ACCESS_DENIED &&
        error != ERROR_BAD_EXE_FORMAT)
      throw std::system_error(static_cast<int>(error), std::system_category(), "cannot start a process");
    handle_->end = ProcessEnd{false, 127, 0};
    return;
  }
  ::AssignProcessToJobObject(handle_->job.get(), process.hProcess);
  ::ResumeThread(process.hThread);
}

Process::~Process() {
  if (handle_->end) return;
  kill();
  (void)wait();
}

std::optional<ProcessEnd> Process::end() {
  (void)handle_->take(0);
  return handle_->end;
}

ProcessEnd Process::wait() {
  (void)handle_->take(INFINITE);
  return *handle_->end;
}

void Process::kill() {
  if (!handle_->end) ::TerminateJobObject(handle_->job.get(), 1);
}

std::string name_of_crash(int code) {
  char text[32];
  std::snprintf(text, sizeof text, "exception %08X", static_cast<unsigned>(code));
  return text;
}

void become(const fs::path& program, char* const* arguments) {
  std::vector<std::string> words = {program.string()};
  for (std::size_t k = 1; arguments[k] != nullptr; ++k) words.emplace_back(arguments[k]);
  STARTUPINFOW start = {};
  start.cb = sizeof start;
  PROCESS_INFORMATION process = {};
  std::wstring line = command_line(words);
  if (::CreateProcessW(program.c_str(), line.data(), nullptr, nullptr, TRUE, 0, nullptr, nullptr, &start, &process) ==
      0) {
    errno = ENOEXEC;
    return;
  }
  ::SetConsoleCtrlHandler(nullptr, TRUE);  // Ctrl-C is for the program; said now, since it would inherit this
  ::WaitForSingleObject(process.hProcess, INFINITE);
  DWORD code = 0;
  ::GetExitCodeProcess(process.hProcess, &code);
  std::exit(static_cast<int>(code));
}

}  // namespace strata::system
