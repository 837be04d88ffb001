// SPDX-License-Identifier: BSD-3-Clause
#include "program.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <fstream>
#include <iterator>
#include <sstream>

namespace multimesh::tools::test {

namespace {

constexpr const char* out_name = ".stdout";
constexpr const char* err_name = ".stderr";

void redirect(const char* name, int to) {
  const int fd = ::open(name, O_WRONLY | O_CREAT | O_TRUNC, 0600);
  ::dup2(fd, to);
  ::close(fd);
}

std::string all_of(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

void ProgramTest::SetUp() {
  static std::atomic<int> counter = 0;
  directory = fs::temp_directory_path() /
              ("multimesh-tool-" + std::to_string(::getpid()) + "-" + std::to_string(counter++));
  fs::create_directories(directory);
}

void ProgramTest::TearDown() {
  fs::permissions(directory, fs::perms::owner_all, fs::perm_options::add);
  fs::remove_all(directory);
}

pid_t ProgramTest::start(const Arguments& arguments, const std::function<void()>& prepare) const {
  std::vector<char*> argv;
  static const std::string program = MULTIMESH_PROGRAM;
  argv.push_back(const_cast<char*>(program.c_str()));
  for (const std::string& a : arguments) argv.push_back(const_cast<char*>(a.c_str()));
  argv.push_back(nullptr);
  const pid_t child = ::fork();
  if (child != 0) return child;
  if (::chdir(directory.c_str()) != 0) ::_exit(126);
  redirect(out_name, STDOUT_FILENO);
  redirect(err_name, STDERR_FILENO);
  if (prepare) prepare();
  ::execv(argv[0], argv.data());
  ::_exit(127);
}

Ended ProgramTest::wait(pid_t process) const {
  int status = 0;
  ::waitpid(process, &status, 0);
  Ended e;
  if (WIFEXITED(status)) e.status = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) e.signal = WTERMSIG(status);
  e.out = all_of(directory / out_name);
  e.err = all_of(directory / err_name);
  return e;
}

Ended ProgramTest::run(const Arguments& arguments, const std::function<void()>& prepare) const {
  return wait(start(arguments, prepare));
}

Ended ProgramTest::decimate(const std::string& in, const std::string& out, const Arguments& more) const {
  Arguments arguments{"decimate", in, "-o", out};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return run(arguments);
}

Json ProgramTest::info(const std::string& file) const {
  const Ended e = run({"info", file, "--json"});
  EXPECT_EQ(e.status, 0) << file << ": " << e.err;
  return e.status == 0 ? Json::parse(e.out) : Json();
}

fs::path ProgramTest::file(const std::string& name, const std::string& content) const {
  fs::create_directories((directory / name).parent_path());
  std::ofstream(directory / name, std::ios::binary) << content;
  return directory / name;
}

std::string ProgramTest::content(const std::string& name) const {
  return all_of(directory / name);
}

std::vector<std::string> ProgramTest::names(const std::string& below) const {
  std::vector<std::string> found;
  for (const auto& entry : fs::directory_iterator(directory / below)) {
    const std::string name = entry.path().filename().string();
    if (name != out_name && name != err_name) found.push_back(name);
  }
  std::sort(found.begin(), found.end());
  return found;
}

std::string grid_obj(int n, bool seam, const std::string& head) {
  std::ostringstream out;
  out << head;
  const int side = n + 1;
  const auto number = [&](int i, int j) { return i * side + j + 1; };
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) out << "v " << i << ' ' << j << " 0\n";
  for (const double shift : {0.0, 2.0})
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j <= n; ++j) out << "vt " << i / double(n) + shift << ' ' << j / double(n) << '\n';
  for (int i = 0; i < n; ++i) {
    const bool right = 2 * i >= n;
    if (i == 0) out << "g left\nusemtl left\n";
    if (right && 2 * (i - 1) < n) out << "g right\nusemtl right\n";
    const int shift = seam && right ? side * side : 0;
    for (int j = 0; j < n; ++j) {
      const int a = number(i, j), b = number(i + 1, j), c = number(i + 1, j + 1), d = number(i, j + 1);
      const auto corner = [&](int v) { out << ' ' << v << '/' << v + shift; };
      out << 'f', corner(a), corner(b), corner(c), out << "\nf", corner(a), corner(c), corner(d), out << '\n';
    }
  }
  return out.str();
}

fs::path shared(const std::string& name) {
  const fs::path root = MULTIMESH_SHARED_DATA;
  return !root.empty() && fs::is_directory(root / name) ? root / name : fs::path();
}

}  // namespace multimesh::tools::test
