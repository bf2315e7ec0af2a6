#include "loosefit/render/screen.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <optional>
#include <thread>

#include "loosefit/render/x_server.h"
#include "support/scratch_folder.h"

namespace loosefit::render {
namespace {

/// An environment variable that has its old value again at the end.
class Variable {
 public:
  Variable(const char* name, const char* value) : name_(name) {
    if (const char* old = std::getenv(name)) old_ = old;
    value ? setenv(name, value, 1) : unsetenv(name);
  }
  ~Variable() { old_ ? setenv(name_, old_->c_str(), 1) : unsetenv(name_); }

 private:
  const char* name_;
  std::optional<std::string> old_;
};

std::string lock_of(const std::string& display) { return "/tmp/.X" + display.substr(1) + "-lock"; }
std::string socket_of(const std::string& display) { return "/tmp/.X11-unix/X" + display.substr(1); }

bool left_over(const std::string& display) {
  return std::filesystem::exists(lock_of(display)) || std::filesystem::exists(socket_of(display));
}

/// Waits up to ten seconds for what another process does.
bool comes_true(const std::function<bool()>& what) {
  for (int i = 0; i < 1000; ++i) {
    if (what()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

TEST(XServer, TakesANumberOfItsOwnAndLeavesNothing) {
  std::string first, second;
  {
    const XServer one, other;
    first = one.name();
    second = other.name();
    EXPECT_NE(first, second);
    EXPECT_NE(one.cookie(), other.cookie());
    EXPECT_TRUE(left_over(first));
    EXPECT_EQ(getpgid(one.process()), one.process()) << "Ctrl-C must not reach it";
  }
  EXPECT_FALSE(left_over(first));
  EXPECT_FALSE(left_over(second));
}

TEST(XServer, EndsWithAProcessThatIsKilled) {
  int channel[2];
  ASSERT_EQ(pipe(channel), 0);
  const pid_t child = fork();
  if (child == 0) {
    const XServer server;
    const std::string text = server.name() + " " + std::to_string(server.process()) + "\n";
    if (write(channel[1], text.data(), text.size()) < 0) _exit(1);
    for (;;) pause();
  }
  close(channel[1]);
  std::string text;
  for (char c; read(channel[0], &c, 1) == 1 && c != '\n';) text += c;
  close(channel[0]);
  ASSERT_NE(text.find(' '), std::string::npos) << text;
  const std::string name = text.substr(0, text.find(' '));
  const pid_t server = std::stoi(text.substr(text.find(' ')));
  EXPECT_EQ(kill(server, 0), 0);
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  EXPECT_TRUE(comes_true([&] { return !left_over(name); })) << name;
}

TEST(Screen, IsAnOwnOneWhereDisplayNamesNoneOrADeadOne) {
  for (const char* display : {static_cast<const char*>(nullptr), "", "nonsense", ":54321"}) {
    const Variable named("DISPLAY", display);
    const Screen screen;
    EXPECT_EQ(screen.str().rfind("own screen :", 0), 0u) << screen.str();
    EXPECT_NE(screen.window(), nullptr);
  }
}

TEST(Screen, IsTheGivenOneWhereItAnswersAndTakesTheKey) {
  const XServer server;  // one that asks for a key
  const Variable given("DISPLAY", server.name().c_str());
  {
    const Variable no_keys("XAUTHORITY", "/nowhere");
    const Screen screen;
    EXPECT_EQ(screen.str().rfind("own screen :", 0), 0u) << screen.str();
  }
  const support::ScratchFolder scratch;
  const std::string file = (scratch / "key").string();
  std::ofstream(file, std::ios::binary)
      << std::string("\xff\xff\0\0\0\0\0\x12MIT-MAGIC-COOKIE-1\0\x10", 28) + server.cookie();
  {
    const Variable keys("XAUTHORITY", file.c_str());
    const Screen screen;
    EXPECT_EQ(screen.str(), "display " + server.name());
  }
}

TEST(Screen, IsMissedInWordsWhereThereIsNoXvfbEither) {
  const Variable path("PATH", "/nowhere");
  for (const char* display : {static_cast<const char*>(nullptr), "nonsense", ":54321"}) {
    const Variable named("DISPLAY", display);
    try {
      const Screen screen;
      ADD_FAILURE() << screen.str();
    } catch (const NoScreen& error) {
      const std::string text = error.what();
      EXPECT_NE(text.find(display ? display : "DISPLAY is not set"), std::string::npos) << text;
      EXPECT_NE(text.find("no Xvfb on PATH"), std::string::npos) << text;
      EXPECT_NE(error.hint().find("xvfb"), std::string::npos);
    }
  }
}

TEST(Screen, AnXvfbThatDoesNotStartIsSaidAndWaitedForNoLonger) {
  const support::ScratchFolder dir;
  std::filesystem::create_symlink("/bin/false", dir / "Xvfb");
  {
    const Variable path("PATH", dir.path().c_str());
    const Variable none("DISPLAY", nullptr);
    EXPECT_THROW(
        try { Screen(); } catch (const NoScreen& error) {
          EXPECT_NE(std::string(error.what()).find("does not come up"), std::string::npos);
          throw;
        },
        NoScreen);
  }
}

}  // namespace
}  // namespace loosefit::render
