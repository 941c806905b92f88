// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mesh/gmsh_program.hpp"

#include "percolith/core/error.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

namespace percolith::mesh {
namespace {

[[noreturn]] void fail_start(const std::string& program, int problem) {
  throw FileError(fmt::format("error: the program '{}' cannot be started: {}", program,
                              std::strerror(problem)));
}

/// A pipe whose ends are closed on the way out and not inherited by other programs.
class Pipe {
public:
  explicit Pipe(const std::string& program) {
    if (pipe2(ends_.data(), O_CLOEXEC) != 0) {
      fail_start(program, errno);
    }
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  ~Pipe() {
    close_writer();
    close(ends_[0]);
  }
  [[nodiscard]] int writer() const { return ends_[1]; }
  void close_writer() {
    if (ends_[1] >= 0) {
      close(ends_[1]);
      ends_[1] = -1;
    }
  }
  [[nodiscard]] std::string read_all() const {
    std::string text;
    std::array<char, 4096> buffer;
    for (;;) {
      const ssize_t count = read(ends_[0], buffer.data(), buffer.size());
      if (count > 0) {
        text.append(buffer.data(), static_cast<std::size_t>(count));
      } else if (count == 0 || errno != EINTR) {
        return text;
      }
    }
  }

private:
  std::array<int, 2> ends_{-1, -1};
};

/// Where the program's standard streams lead.
class SpawnStreams {
public:
  explicit SpawnStreams(int output) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions_, output, STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions_, output, STDERR_FILENO);
  }
  SpawnStreams(const SpawnStreams&) = delete;
  SpawnStreams& operator=(const SpawnStreams&) = delete;
  ~SpawnStreams() { posix_spawn_file_actions_destroy(&actions_); }
  [[nodiscard]] const posix_spawn_file_actions_t* get() const { return &actions_; }

private:
  posix_spawn_file_actions_t actions_{};
};

int wait_for(pid_t process) {
  int status = 0;
  while (waitpid(process, &status, 0) < 0) {
    if (errno != EINTR) {
      return -1;
    }
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace

ProgramResult run_program(const std::vector<std::string>& command) {
  std::vector<std::string> words = command;
  std::vector<char*> arguments;
  arguments.reserve(words.size() + 1);
  for (std::string& word : words) {
    arguments.push_back(word.data());
  }
  arguments.push_back(nullptr);
  Pipe pipe(command.front());
  const SpawnStreams streams(pipe.writer());
  pid_t process = 0;
  const int problem =
      posix_spawnp(&process, arguments[0], streams.get(), nullptr, arguments.data(), environ);
  ProgramResult result;
  if (problem == ENOENT) {
    return result;
  }
  if (problem != 0) {
    fail_start(command.front(), problem);
  }
  result.found = true;
  pipe.close_writer();
  result.output = pipe.read_all();
  result.exit_code = wait_for(process);
  return result;
}

}  // namespace percolith::mesh
