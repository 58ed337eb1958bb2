// SPDX-License-Identifier: GPL-3.0-or-later
// Children that do everything but what they should. Deadlines are generous where an answer is due,
// and short where none can come.

#include "verify/harness/process.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <limits>
#include <string>
#include <thread>
#include <utility>

#include "fathom/numbers.hpp"
#include "tests/support/property.hpp"
#include "verify/harness/protocol.hpp"
#include "verify/harness/seen_case.hpp"

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

constexpr const char* hello_with_all =
    R"({"type":"hello","protocol":"fathom/subject/1","name":"x","version":"1","precision":"binary32",)"
    R"("conventions":{"touching":"separate","depth":"negative","moves":"b","unit":false},"library":"fcl",)"
    R"("capabilities":{"faces":true,"more":1},"promises":["witness","depth"],"settings":{"eps":1e-4,"deep":{"a":[1]},"mode":"x"},"unknown":[]})";

std::string without(std::string text, const std::string& part) { return text.erase(text.find(part), part.size()); }
std::string with(std::string text, const std::string& part, const std::string& other) {
  return text.replace(text.find(part), part.size(), other);
}

TEST(Hello, IsReadAndWrittenBack) {
  const SubjectInfo info = read_hello(hello_with_all);
  EXPECT_EQ(info.name, "x");
  EXPECT_EQ(info.format, Precision::binary32);
  EXPECT_EQ(info.conventions.touching, Conventions::Touching::separate);
  EXPECT_EQ(info.conventions.depth, Conventions::Sign::negative);
  EXPECT_EQ(info.conventions.moves, Conventions::Body::b);
  EXPECT_FALSE(info.conventions.unit);
  EXPECT_TRUE(info.wants_faces);
  EXPECT_EQ(info.library, "fcl");
  EXPECT_EQ(info.settings.at("eps"), "1e-4") << "as it was written";
  EXPECT_EQ(info.settings.at("deep"), R"({"a":[1]})");
  EXPECT_EQ(info.settings.size(), 3U);
  EXPECT_EQ(info.promises, (std::set<std::string>{"depth", "witness"}));
  EXPECT_EQ(hello_text(read_hello(hello_text(info))), hello_text(info));
}

TEST(Hello, LacksNothing) {
  for (const char* part :
       {R"("protocol":"fathom/subject/1",)", R"("name":"x",)", R"("version":"1",)", R"("precision":"binary32",)",
        R"("touching":"separate",)", R"("depth":"negative",)", R"("moves":"b",)", R"(,"unit":false)"})
    EXPECT_THROW(read_hello(without(hello_with_all, part)), ProtocolError) << part;
  for (const auto& [part, other] : {std::pair("subject/1", "subject/2"),
                                    {"binary32", "binary16"},
                                    {"\"separate\"", "\"maybe\""},
                                    {"false", "\"no\""},
                                    {R"("name":"x")", R"("name":"")"},
                                    {R"("name":"x")", R"("name":[7])"},
                                    {"{\"touching", "[{\"touching"},
                                    {"\"hello\"", "\"reply\""},
                                    {"{\"eps\":1e-4", "3,\"x\":{\"y\":1"}})
    EXPECT_THROW(read_hello(with(hello_with_all, part, other)), ProtocolError) << other;
  for (const char* line : {"", "hello", "{", "[]", "\"hello\"", "null", "{}", "\xff\xfe"})
    EXPECT_THROW(read_hello(line), ProtocolError) << line;
}

std::string reply_with(const std::string& fields) { return R"({"type":"reply","id":"7",)" + fields + "}"; }
Reply replied(const std::string& fields, Precision precision = Precision::binary64) {
  return std::get<Reply>(read_reply(reply_with(fields), precision).said);
}

TEST(Replies, AreRead) {
  const Reply reply = replied(
      R"("overlap":true,"depth":0.1,"direction":[1,-0.5,2e3],"witness":{"a":[1,2,3],"b":["0x1.8p1",5,6]},"x":{})");
  EXPECT_TRUE(reply.overlap);
  EXPECT_EQ(reply.depth, 0.1);
  EXPECT_EQ(reply.direction, (Triple{1, -0.5, 2000}));
  EXPECT_EQ(reply.witness_a, (Triple{1, 2, 3}));
  EXPECT_EQ(reply.witness_b, (Triple{3, 5, 6}));
  EXPECT_EQ(read_reply(R"({"type":"reply","id":7,"overlap":false})", Precision::binary64).ticket, "7")
      << "a number will do";
  EXPECT_EQ(std::get<Failed>(read_reply(reply_with(R"("failed":"a \"b\" 1e5 nan")"), Precision::binary64).said).why,
            "a \"b\" 1e5 nan");
  EXPECT_EQ(std::get<Unsupported>(read_reply(reply_with(R"("unsupported":"flat")"), Precision::binary64).said).why,
            "flat");
}

TEST(Replies, HaveContacts) {
  const Reply reply =
      replied(R"("overlap":true,"depth":1,"contacts":[{"position":[0.1,2,3]},{"position":[4,5,6],"depth":0.1}])",
              Precision::binary32);
  EXPECT_EQ(reply.contacts, (std::vector<ContactPoint>{{{static_cast<double>(0.1F), 2, 3}, {}},
                                                       {{4, 5, 6}, static_cast<double>(0.1F)}}));
  for (const char* contacts : {"[]", "{}", "null", "[[1,2,3]]", "[{}]", R"([{"depth":1}])", R"([{"position":[1,2]}])",
                               R"([{"position":[1,2,3],"depth":null}])"})
    EXPECT_THROW(replied(std::string(R"("overlap":true,"contacts":)") + contacts), ProtocolError) << contacts;
  EXPECT_THROW(replied(R"("failed":"no","contacts":[{"position":[1,2,3]}])"), ProtocolError);
  EXPECT_NE(read_reply(reply_with(R"("overlap":true,"contacts":[{"position":[1,2,3],"dept":1}])"), Precision::binary64)
                .remark,
            "");
}

TEST(Replies, HaveADistance) {
  EXPECT_EQ(replied(R"("overlap":false,"distance":0.1)", Precision::binary32).distance, static_cast<double>(0.1F));
  EXPECT_THROW(replied(R"("overlap":false,"distance":null)"), ProtocolError);
  EXPECT_THROW(replied(R"("failed":"no","distance":1)"), ProtocolError);
  EXPECT_NE(read_reply(reply_with(R"("overlap":false,"distnace":1)"), Precision::binary64).remark, "");
}

TEST(Replies, NumbersOfPrintf) {
  for (const char* nan : {"nan", "-nan", "NaN", "NAN", "+nan", "nan(0x8000)", "\"nan\"", "\"-nan\"", "-nan(snan)"})
    EXPECT_TRUE(std::isnan(*replied(std::string(R"("overlap":true,"depth":)") + nan).depth)) << nan;
  const double inf = std::numeric_limits<double>::infinity();
  for (const char* text : {"inf", "Infinity", "INF", "\"inf\"", "+inf", "1e400", "1.8e308"})
    EXPECT_EQ(replied(std::string(R"("overlap":true,"depth":)") + text).depth, inf) << text;
  for (const char* text : {"-inf", "-Infinity", "\"-inf\"", "-1e400"})
    EXPECT_EQ(replied(std::string(R"("overlap":true,"depth":)") + text).depth, -inf) << text;
  EXPECT_EQ(replied(R"("overlap":true,"direction":[nan,.5,-0.])").direction->at(1), 0.5);
}

// Readers differ in which of the two they take.
TEST(Replies, HaveEachFieldOnce) {
  for (const char* fields :
       {R"("overlap":true,"depth":1,"depth":1)", R"("overlap":true,"overlap":true)", R"("id":"7","overlap":true)",
        R"("overlap":true,"depth":1,"\u0064epth":2)", R"("overlap":true,"x":1,"x":2)", R"("failed":"a","failed":"b")",
        R"("overlap":true,"depth":1,"witness":{"a":[1,2,3],"a":[1,2,3]})",
        R"("overlap":true,"depth":1,"contacts":[{"position":[1,2,3],"depth":1,"depth":1}])"}) {
    try {
      read_reply(reply_with(fields), Precision::binary64);
      ADD_FAILURE() << fields;
    } catch (const ProtocolError& error) {
      EXPECT_TRUE(std::string(error.what()).starts_with("expected each field once, found '")) << error.what();
    }
  }
  EXPECT_NO_THROW(
      replied(R"("overlap":true,"depth":1,"contacts":[{"position":[1,2,3]},{"position":[1,2,3]}],"x":{"depth":1})"));
  EXPECT_THROW(read_hello(with(hello_with_all, R"("name":"x")", R"("name":"x","name":"x")")), ProtocolError);
}

// As any other number that is too large or too small.
TEST(Replies, ExponentsOfAnySize) {
  const double inf = std::numeric_limits<double>::infinity();
  for (const Precision precision : {Precision::binary64, Precision::binary32}) {
    const auto depth = [&](const std::string& text) {
      return *replied(R"("overlap":true,"depth":)" + text, precision).depth;
    };
    for (const char* text : {"1e400", "1e100001", "1e+99999999999", "0.1E0000999999", "0x1p400001", "0x.8P+99999999999",
                             "\"1e99999999999\""})
      EXPECT_EQ(depth(text), inf) << text;
    for (const char* text : {"-1e99999999999", "-0x1p99999999999"}) EXPECT_EQ(depth(text), -inf) << text;
    for (const char* text : {"1e-99999999999", "-1e-100001", "0e99999999999", "0x1p-99999999999", "0x0p99999999999"})
      EXPECT_EQ(depth(text), 0) << text;
    EXPECT_EQ(depth("15e-0000000000001"), 1.5);
    for (const char* text : {"1e", "1e+", "1e9999999999x", "0x1p", "0x1p99999999999.5"})
      EXPECT_THROW(depth(text), ProtocolError) << text;
  }
}

TEST(Replies, AreRoundedOnce) {
  EXPECT_EQ(replied(R"("overlap":true,"depth":0.1)", Precision::binary32).depth, static_cast<double>(0.1F));
  // Half way between two binary32 numbers, and a little more, which binary64 does not see.
  EXPECT_EQ(replied(R"("overlap":true,"depth":1.000000059604644775390625)", Precision::binary32).depth, 1.0);
  EXPECT_EQ(replied(R"("overlap":true,"depth":1.00000005960464477539062500001)", Precision::binary32).depth,
            1 + 0x1p-23);
  EXPECT_TRUE(std::isinf(*replied(R"("overlap":true,"depth":1e39)", Precision::binary32).depth));
}

TEST(Replies, RefusesWhatIsNone) {
  for (const char* fields : {R"("overlap":false,"depth":null)",
                             R"("overlap":false,"direction":null)",
                             R"("overlap":true,"witness":{"a":null})",
                             R"("overlap":true,"depth":"1/1")",
                             R"("overlap":true,"depth":yes)",
                             R"("overlap":true,"unsupported":"flat")",
                             R"("failed":7)",
                             R"("failed":"x","depth":1)",
                             R"("depth":1)",
                             R"("overlap":1)",
                             R"("overlap":"true")",
                             R"("overlap":true,"depth":"deep")",
                             R"("overlap":true,"depth":[1])",
                             R"("overlap":true,"depth":true)",
                             R"("overlap":true,"direction":[1,2])",
                             R"("overlap":true,"direction":[1,2,3,4])",
                             R"("overlap":true,"direction":{"x":1})",
                             R"("overlap":true,"witness":[1])",
                             R"("overlap":true,"witness":{"a":7})",
                             R"("failed":1,"x":[)",
                             R"("overlap":true,"depth":nano)",
                             R"("overlap":true,"depth":0x)",
                             R"("overlap":true,"depth":--1)",
                             R"("overlap":true,"depth":nan(1,"x":2)"})
    EXPECT_THROW(read_reply(reply_with(fields), Precision::binary64), ProtocolError) << fields;
  EXPECT_THROW(read_reply(R"({"type":"reply","overlap":true})", Precision::binary64), ProtocolError);
  EXPECT_THROW(read_reply(R"({"id":"7","overlap":true})", Precision::binary64), ProtocolError);
  EXPECT_THROW(read_reply(std::string(1'000'000, '['), Precision::binary64), ProtocolError);
  EXPECT_THROW(read_reply(reply_with(R"("overlap":true)") + '\0' + "junk", Precision::binary64), ProtocolError);
}

TEST(Replies, NumbersAreToldOfAsTheyWereWritten) {
  try {
    read_reply(reply_with(R"("overlap":true,"direction":[1,2.50,{"x":1e-6},"3"])"), Precision::binary64);
    FAIL() << "four components";
  } catch (const ProtocolError& error) {
    EXPECT_NE(std::string(error.what()).find(R"([1,2.50,{"x":1e-6},"3"])"), std::string::npos) << error.what();
  }
}

TEST(Replies, NoBytesDoHarm) {
  holds({.seed = 77, .runs = 100}, [](const std::string& bytes) {
    try {
      read_reply(bytes, Precision::binary32);
    } catch (const ProtocolError&) {
    }
    try {
      read_hello(bytes);
    } catch (const ProtocolError&) {
    }
    is_hello(bytes);
  });
}

TEST(Numbers, AreKeptAsTheyWereWritten) {
  const auto kept = [](const std::string& line) { return json_on(line).written(JsonValue::Form::sorted).text(); };
  EXPECT_EQ(kept(R"({"a 1":-nan(0x8), "b":[1, 2.5e-3,true,null,007],"c":"x\" 7"})"),
            R"({"a 1":-nan(0x8),"b":[1,2.5e-3,true,null,007],"c":"x\" 7"})");
  EXPECT_EQ(kept(R"({"b":[no]})"), "null");
  EXPECT_EQ(kept("\"open 1"), "null");
  EXPECT_EQ(number_word("-Infinity,"), 9u);
  EXPECT_EQ(number_word("true"), 0u);
  EXPECT_EQ(read_integer("7.0"), "7");
  EXPECT_EQ(read_integer("7.5"), std::nullopt);
}

TEST(Runs, ReadBackAsTheSameNumbers) {
  holds({.seed = 77, .runs = 100}, [](double x, double y) {
    RC_PRE(std::isfinite(x) && std::isfinite(y));
    const Case pair{"id", {{{exact_value(x), exact_value(y), 0}}}, {{{1, 2, 3}}}};
    const std::string text = run_message("1", pair, Precision::binary64, true);
    const std::string start = "{\"type\":\"run\",\"id\":\"1\",\"a\":{\"vertices\":[[";
    RC_ASSERT(text.substr(0, start.size()) == start);
    const std::size_t comma = text.find(',', start.size());
    RC_ASSERT(std::stod(text.substr(start.size(), comma - start.size())) == x);
    RC_ASSERT(text.find("faces") == text.npos);  // a point is flat
  });
}

TEST(Runs, Binary32ReadsBackThroughBothTypes) {
  const Case pair{"id", {{{exact_value(0.1F), 0, 0}}}, {{{0, 0, 0}}}};
  EXPECT_NE(run_message("1", pair, Precision::binary32, false).find("[[0.10000000149011612,0,0]]"), std::string::npos);
}

TEST(Faces, OfACubeWithMorePoints) {
  std::vector<Point> points{{0, 0, 0}};  // in the middle
  for (int i = 0; i < 8; ++i) points.push_back({i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1});
  points.push_back({1, 0, 0});  // in a facet
  const Faces faces = faces_of(points);
  ASSERT_EQ(faces.size(), 6U);
  for (const auto& face : faces) {
    ASSERT_EQ(face.size(), 4U);
    for (std::size_t i = 0; i < face.size(); ++i) {
      EXPECT_TRUE(face[i] >= 1 && face[i] <= 8);
      // Seen from outside each corner is a left turn: the determinant of three corners, O inside,
      // is positive.
      const Point &p = points[face[i]], &q = points[face[(i + 1) % 4]], &r = points[face[(i + 2) % 4]];
      const mpq_class det =
          p.x * (q.y * r.z - q.z * r.y) + p.y * (q.z * r.x - q.x * r.z) + p.z * (q.x * r.y - q.y * r.x);
      EXPECT_GT(det, 0);
    }
  }
}

TEST(Seen, OverflowAndDigest) {
  const Case large{"id", {{{mpq_class("1" + std::string(39, '0')), 0, 0}}}, {{{0, 0, 0}}}};
  EXPECT_FALSE(as_seen(large, Precision::binary32));
  EXPECT_TRUE(as_seen(large, Precision::binary64));
  const Case tenth{"id", {{{mpq_class(1, 10), 0, 0}}}, {{{0, 0, 0}}}};
  EXPECT_EQ(as_seen(tenth, Precision::binary32)->a.points[0].x, exact_value(0.1F));
  EXPECT_NE(digest_of(*as_seen(tenth, Precision::binary32)), digest_of(*as_seen(tenth, Precision::binary64)));
  Case moved = tenth;
  std::swap(moved.a, moved.b);
  EXPECT_NE(digest_of(moved), digest_of(tenth));
  moved = tenth;
  moved.id = "other";
  EXPECT_EQ(digest_of(moved), digest_of(tenth));
  EXPECT_EQ(digest_of(tenth).size(), 16U);
}

TEST(Replies, RemarkOnFieldsThatLookMisspelt) {
  const auto remark = [](const std::string& fields) {
    return read_reply(reply_with("\"overlap\":true" + fields), Precision::binary64).remark;
  };
  EXPECT_EQ(remark(R"(,"depht":1)"), "the field 'depht' is not read: is 'depth' meant?");
  EXPECT_EQ(remark(R"(,"depht":1,"depth":1,"time":3,"notes":{"depht":1})"), "")
      << "it is there; and what is far from any field is left alone";
  EXPECT_EQ(remark(R"(,"directoin":1,"witness":{"A":[0,0,0],"b":[0,0,0]})"),
            "the field 'directoin' is not read: is 'direction' meant?; the field 'A' is not read: is 'a' meant?");
}

}  // namespace
}  // namespace fathom::harness
