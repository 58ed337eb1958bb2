// SPDX-License-Identifier: GPL-3.0-or-later
// Children that do everything but what they should. Deadlines are generous where an answer is due,
// and short where none can come.
#include "verify/harness/process.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <string>
#include <thread>
#include <utility>

namespace fathom::harness {
namespace {

using Clock = Process::Clock;
using Got = Process::Got;
using namespace std::chrono_literals;

Clock::time_point soon() { return Clock::now() + 200ms; }
Clock::time_point in_time() { return Clock::now() + 60s; }

std::string line_of(Process& process) {
  std::string line;
  EXPECT_EQ(process.read_line(line, in_time()), Got::line);
  return line;
}

TEST(Process, Echoes) {
  Process process("exec cat");
  for (const std::string text : {"one", "", "three \xff\x01"}) {
    process.send(text);
    EXPECT_EQ(line_of(process), text);
  }
  EXPECT_EQ(process.waiting(), "");
  EXPECT_FALSE(process.gone());
  process.close_input();
  std::string rest;
  EXPECT_EQ(process.read_line(rest, in_time()), Got::end);
  EXPECT_EQ(rest, "");
  const auto ending = process.ending(in_time());
  ASSERT_TRUE(ending);
  EXPECT_TRUE(ending->in_good_order());
}

TEST(Process, KnowsWhatIsUnread) {
  Process reader("exec cat");
  reader.send("one");
  EXPECT_EQ(line_of(reader), "one");
  EXPECT_FALSE(reader.last_is_unread());
  for (const std::string& line : {std::string("two"), std::string(1 << 20, 'x')}) {
    Process dying("read x; echo; sleep 0.02; kill -9 $$");
    dying.send("one");
    line_of(dying);
    dying.send(line);
    EXPECT_TRUE(dying.ending(in_time()));
    EXPECT_TRUE(dying.last_is_unread()) << line.size();
    dying.close_input();
    EXPECT_TRUE(dying.last_is_unread()) << line.size();
  }
}

TEST(Process, NoShellStandsBetweenWhereTheCommandIsPlain) {
  for (const std::string plain : {"sleep 60", "/bin/sleep 60", "'/bin/sleep' 60", "  \"sleep\" '6;0'",
                                  "sleep 60 2>/dev/null", "sleep $HOME \"$HOME\""})
    EXPECT_EQ(without_shell(plain), "exec " + plain);
  for (const std::string other :
       {"exit 3", "exec sleep 60", "sleep 1; sleep 1", "sleep 1 | cat", "sleep 1 &", "A=1 sleep 60", "$SLEEP 60",
        "\"$SLEEP\" 60", "(sleep 60)", "sleep $(cat x)", "sleep `cat x`", "no-such-program x", "./no/such x", "/tmp",
        "", " ", "sleep 'x", "sleep 1\nsleep 1", "if true"})
    EXPECT_EQ(without_shell(other), other);
}

TEST(Process, MuchInAndOutAtOnce) {
  Process process("exec cat");
  const std::string text(4 << 20, 'x');  // far more than a pipe holds
  process.send(text);
  EXPECT_GT(process.unsent(), 0U);
  EXPECT_EQ(line_of(process), text);
  EXPECT_EQ(process.unsent(), 0U);
}

TEST(Process, NeverReads) {
  Process process("exec sleep 60");
  process.send(std::string(1 << 20, 'x'));
  std::string line;
  EXPECT_EQ(process.read_line(line, soon()), Got::time_out);
  EXPECT_GT(process.unsent(), 0U);
}

TEST(Process, IsGoneBeforeItIsWrittenTo) {
  Process process("exit 3");
  const auto ending = process.ending(in_time());
  ASSERT_TRUE(ending);
  EXPECT_EQ(described(*ending), "ended with exit code 3");
  process.send(std::string(1 << 20, 'x'));  // SIGPIPE would end this test
  std::string line;
  EXPECT_EQ(process.read_line(line, in_time()), Got::end);
  EXPECT_TRUE(process.gone());
}

TEST(Process, Signals) {
  for (const char* command :
       {"kill -SEGV $$", "sh -c 'kill -SEGV $$'; exit $?"}) {  // the shell's own signal, and one of its child
    Process process(command);
    const auto ending = process.ending(in_time());
    ASSERT_TRUE(ending);
    EXPECT_EQ(described(*ending), "killed by signal 11 (Segmentation fault)") << command;
  }
}

TEST(Process, LinesThatAreCut) {
  Process process("printf 'whole\\nhalf'");
  EXPECT_EQ(line_of(process), "whole");
  std::string rest;
  EXPECT_EQ(process.read_line(rest, in_time()), Got::end);
  EXPECT_EQ(rest, "half");
}

TEST(Process, EndlessLine) {
  Process process("exec tr '\\0' x < /dev/zero");
  std::string line;
  EXPECT_EQ(process.read_line(line, in_time()), Got::too_long);
}

TEST(Process, SlowBytesDoNotMoveTheDeadline) {
  Process process("while :; do printf x; sleep 0.01; done");
  std::string line;
  EXPECT_EQ(process.read_line(line, soon()), Got::time_out);
}

TEST(Process, EndlessErrors) {
  Process process("while :; do echo 0123456789abcdef >&2; done");
  std::string line;
  EXPECT_EQ(process.read_line(line, soon()), Got::time_out);
  EXPECT_LE(process.last_words().size(), kept_of_stderr);
  EXPECT_NE(process.last_words().find("0123456789abcdef"), std::string::npos);
}

TEST(Process, AChildHoldsThePipeOpen) {
  Process process("sleep 60 & echo said; kill -KILL $$");
  EXPECT_EQ(line_of(process), "said");
  std::string rest;
  EXPECT_EQ(process.read_line(rest, in_time()), Got::end);
  EXPECT_EQ(described(*process.ending(in_time())), "killed by signal 9 (Killed)");
}

TEST(Process, TheWholeGroupIsKilled) {
  std::string pid;
  {
    Process process("sleep 60 & echo $!; wait");
    pid = line_of(process);
  }
  // The orphan is gone or a zombie that its new parent has yet to reap.
  const auto state = [&] {
    Process ask("cat /proc/" + pid + "/stat 2>/dev/null; echo");
    return line_of(ask);
  };
  std::string found = state();
  for (int i = 0; i < 500 && !found.empty() && found.find(") Z ") == std::string::npos; ++i) {
    std::this_thread::sleep_for(10ms);
    found = state();
  }
  EXPECT_TRUE(found.empty() || found.find(") Z ") != std::string::npos) << found;
}

TEST(Process, ClosesItsOutputAndLivesOn) {
  Process process("exec >&-; exec sleep 60");
  std::string line;
  EXPECT_EQ(process.read_line(line, in_time()), Got::end);
  EXPECT_TRUE(process.gone());
  EXPECT_FALSE(process.ending(soon()));
}

TEST(Process, StopsWaiting) {
  bool stop = false;
  Process process("exec sleep 60", [&] { return std::exchange(stop, true); });
  std::string line;
  EXPECT_EQ(process.read_line(line, in_time()), Got::stopped);
}

TEST(Process, InheritsNoFiles) {
  const int file = ::open("/dev/null", O_RDONLY);  // not closed on exec, as an std::ifstream's
  Process first("exec cat"), second("exec ls /proc/self/fd");
  for (const char* number : {"0", "1", "2", "3"}) EXPECT_EQ(line_of(second), number);  // 3: the folder that is listed
  std::string rest;
  EXPECT_EQ(second.read_line(rest, in_time()), Got::end);
  ::close(file);
}

TEST(Process, HasDefaultSignals) {
  ::signal(SIGPIPE, SIG_IGN);
  Process process("yes | head -1 > /dev/null; grep -E 'SigIgn|SigBlk' /proc/self/status | tr -d '\\t\\n'; echo");
  EXPECT_EQ(line_of(process), "SigBlk:0000000000000000SigIgn:0000000000000000");
  ::signal(SIGPIPE, SIG_DFL);
}

}  // namespace
}  // namespace fathom::harness
