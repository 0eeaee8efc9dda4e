// SPDX-License-Identifier: MIT
#include "tests/cli/program.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>
#include <stdexcept>
#include <sys/resource.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace flipbook::test {

namespace fs = std::filesystem;

namespace {

std::vector<char*> pointers(std::vector<std::string>& words) {
  std::vector<char*> p;
  for (std::string& w : words) p.push_back(w.data());
  p.push_back(nullptr);
  return p;
}

std::vector<std::string> environment(const Setting& setting) {
  std::vector<std::string> all;
  for (char** e = environ; *e; ++e) {
    const std::string entry = *e;
    if (!setting.environment.contains(entry.substr(0, entry.find('=')))) all.push_back(entry);
  }
  for (const auto& [name, value] : setting.environment) all.push_back(name + "=" + value);
  return all;
}

Outcome start(std::vector<std::string> words, const fs::path& where, const Setting& setting) {
  const Folder said;
  const std::string out = said.path() / "out", err = said.path() / "err";
  std::vector<std::string> env = environment(setting);
  const std::vector<char*> argv = pointers(words), envp = pointers(env);
  const pid_t pid = fork();
  if (pid < 0) throw std::runtime_error("fork");
  if (pid == 0) { // only calls that are safe after fork
    const int o = open(out.c_str(), O_WRONLY | O_CREAT, 0600), e = open(err.c_str(), O_WRONLY | O_CREAT, 0600);
    const int in = open("/dev/null", O_RDONLY);
    if (o < 0 || e < 0 || dup2(in, 0) < 0 || dup2(o, 1) < 0 || dup2(e, 2) < 0 || chdir(where.c_str()) != 0) _exit(120);
    if (setting.file_size_limit >= 0) {
      const rlimit limit{static_cast<rlim_t>(setting.file_size_limit), static_cast<rlim_t>(setting.file_size_limit)};
      if (setrlimit(RLIMIT_FSIZE, &limit) != 0) _exit(121);
    }
    execvpe(argv[0], argv.data(), envp.data());
    _exit(122);
  }
  if (setting.interrupt_after_ms >= 0) {
    std::this_thread::sleep_for(std::chrono::milliseconds(setting.interrupt_after_ms));
    kill(pid, SIGINT);
  }
  int status = 0;
  waitpid(pid, &status, 0);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status), read_file(out), read_file(err)};
}

} // namespace

Outcome run(const std::vector<std::string>& arguments, const fs::path& where, const Setting& setting) {
  std::vector<std::string> words = setting.before;
  words.push_back(FLIPBOOK_BINARY_DIR "/flipbook");
  words.insert(words.end(), arguments.begin(), arguments.end());
  return start(words, where, setting);
}

Outcome run_other(const std::vector<std::string>& words, const fs::path& where) {
  return start(words, where, {});
}

Folder::Folder() {
  std::string pattern = fs::temp_directory_path() / "flipbook-test-XXXXXX";
  if (!mkdtemp(pattern.data())) throw std::runtime_error("mkdtemp");
  path_ = pattern;
}

Folder::~Folder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

fs::path Folder::write(const std::string& name, const std::string& text) const {
  std::ofstream(path_ / name, std::ios::binary) << text;
  return path_ / name;
}

std::vector<std::string> Folder::files() const {
  std::vector<std::string> all;
  for (const auto& entry : fs::recursive_directory_iterator(path_)) all.push_back(fs::relative(entry.path(), path_));
  std::sort(all.begin(), all.end());
  return all;
}

void expect_refusal(const Outcome& o, int code, const std::vector<std::string>& says) {
  EXPECT_EQ(o.code, code) << o.err;
  EXPECT_EQ(o.out, "");
  EXPECT_EQ(std::count(o.err.begin(), o.err.end(), '\n'), 1) << o.err;
  for (const std::string& s : says) EXPECT_NE(o.err.find(s), std::string::npos) << s << " is not in " << o.err;
}

std::string read_file(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

} // namespace flipbook::test
