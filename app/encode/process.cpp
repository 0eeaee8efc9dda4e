// SPDX-License-Identifier: MIT
#include "app/encode/process.h"

#include "sim/frame/errors.h"

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <spawn.h>
#include <sstream>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>

namespace flipbook::app {

namespace fs = std::filesystem;

namespace {

/// posix_spawn with the three standard streams set, default signals, and a process group of its own: Ctrl-C reaches us
/// alone and we decide what becomes of the child.
int spawn(pid_t& pid, const fs::path& program, char* const* argv, int input, int errors) {
  posix_spawn_file_actions_t files;
  posix_spawnattr_t how;
  posix_spawn_file_actions_init(&files);
  posix_spawnattr_init(&how);
  posix_spawn_file_actions_adddup2(&files, input, 0);
  posix_spawn_file_actions_addopen(&files, 1, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_adddup2(&files, errors, 2);
  sigset_t signals;
  sigfillset(&signals);
  posix_spawnattr_setsigdefault(&how, &signals);
  sigemptyset(&signals);
  posix_spawnattr_setsigmask(&how, &signals);
  posix_spawnattr_setflags(&how, POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETPGROUP);
  const int error = posix_spawn(&pid, program.c_str(), &files, &how, argv, environ);
  posix_spawnattr_destroy(&how);
  posix_spawn_file_actions_destroy(&files);
  return error;
}

} // namespace

Process::Process(const fs::path& program, const std::vector<std::string>& arguments) {
  // A socket instead of a pipe: writing to one that nobody reads can be asked for without a signal.
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
    throw MachineError("cannot start " + program.string() + ": " + std::generic_category().message(errno));
  input_ = ends[0];
  errors_ = memfd_create("errors", MFD_CLOEXEC);
  std::vector<std::string> words = arguments;
  words.insert(words.begin(), program.string());
  std::vector<char*> argv;
  for (std::string& w : words) argv.push_back(w.data());
  argv.push_back(nullptr);
  const int error = errors_ < 0 ? errno : spawn(pid_, program, argv.data(), ends[1], errors_);
  close(ends[1]);
  if (error == 0) return;
  close_input();
  if (errors_ >= 0) close(errors_);
  throw MachineError("cannot start " + program.string() + ": " + std::generic_category().message(error));
}

Process::~Process() {
  close_input();
  if (pid_ > 0) {
    kill(pid_, SIGKILL);
    while (waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) {
    }
  }
  close(errors_);
}

void Process::close_input() {
  if (input_ >= 0) close(input_);
  input_ = -1;
}

bool Process::write(std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t n = send(input_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(n));
  }
  return true;
}

std::string Process::finish() {
  close_input();
  int status = 0;
  while (waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
  }
  pid_ = -1;
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return {};
  const std::string how = WIFSIGNALED(status)
                              ? "signal " + std::to_string(WTERMSIG(status)) + " (" + strsignal(WTERMSIG(status)) + ")"
                              : "exit code " + std::to_string(WEXITSTATUS(status));
  return how + last_errors();
}

std::string Process::last_errors() const {
  constexpr off_t shown = 600;
  const off_t size = lseek(errors_, 0, SEEK_END);
  std::string text(static_cast<std::size_t>(size < shown ? (size < 0 ? 0 : size) : shown), '\0');
  const ssize_t n = pread(errors_, text.data(), text.size(), size - static_cast<off_t>(text.size()));
  text.resize(n < 0 ? 0 : static_cast<std::size_t>(n));
  std::istringstream lines(text);
  std::string all;
  for (std::string line; std::getline(lines, line);)
    if (!line.empty()) all += (all.empty() ? ": " : "; ") + line;
  return all;
}

std::optional<fs::path> Process::find(std::string_view name) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');) {
    const fs::path candidate = fs::path(folder.empty() ? "." : folder) / name;
    std::error_code ignored;
    if (fs::is_regular_file(candidate, ignored) && access(candidate.c_str(), X_OK) == 0) return candidate;
  }
  return std::nullopt;
}

} // namespace flipbook::app
