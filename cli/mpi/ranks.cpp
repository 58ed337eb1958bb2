// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/mpi/ranks.hpp"

#include <fmt/format.h>

#include <atomic>
#include <boost/mpi/communicator.hpp>
#include <boost/mpi/environment.hpp>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <optional>
#include <stdexcept>
#include <thread>
#include <utility>

#include "cli/io/output.hpp"

namespace fathom::cli {
namespace {

constexpr int tag_task = 1, tag_answer = 2, tag_end = 3;
constexpr char answered = 'a', threw = 'f';  // the first letter of an answer
constexpr auto patience =
    std::chrono::microseconds(100);  // between two looks for messages, as MPI's own waiting keeps a core busy
constexpr auto long_patience = std::chrono::milliseconds(2);  // if no message has come for a while
constexpr int ended_from_outside = 128 + SIGTERM;

volatile std::sig_atomic_t is_to_end = 0;

/// Waits briefly, and longer after many waits without a message.
class Patience {
 public:
  void wait() {
    constexpr int soon = 1000;
    std::this_thread::sleep_for(++waits_ < soon ? std::chrono::microseconds(patience)
                                                : std::chrono::microseconds(long_patience));
  }
  void reset() { waits_ = 0; }

 private:
  int waits_ = 0;
};

/// Ends the process after half a second. mpirun tells all ranks to end, and kills them as soon as
/// one has ended: until then rank 0 must have printed which rank was at which task.
void end_after_rank_0(int) {
  const timespec later{0, 500'000'000};
  nanosleep(&later, nullptr);
  std::_Exit(ended_from_outside);
}

}  // namespace

struct Processes::Mpi {
  boost::mpi::environment environment;
  boost::mpi::communicator world;
};

Processes::Processes(int& argc, char**& argv) : mpi_(new Mpi{{argc, argv, boost::mpi::threading::funneled}, {}}) {}
Processes::~Processes() = default;
int Processes::rank() const { return mpi_->world.rank(); }
int Processes::size() const { return mpi_->world.size(); }

Ranks::Ranks(const Processes& world, Handle own) : world_(world), own_(std::move(own)) {
  for (int rank = world.size() - 1; rank > 0; --rank) idle_.push_back(rank);
}

std::string Ranks::ask(const std::string& task, const std::string& name) {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return !idle_.empty() || !own_is_busy_; });
  if (idle_.empty()) {
    own_is_busy_ = true;
    own_task_ = name;
    lock.unlock();
    std::optional<std::string> answer;
    std::exception_ptr error;
    try {
      answer = own_(task);
    } catch (...) {
      error = std::current_exception();
    }
    lock.lock();
    own_is_busy_ = false;
    changed_.notify_all();
    if (error) std::rethrow_exception(error);
    return *std::move(answer);
  }
  const int rank = idle_.back();
  idle_.pop_back();
  Errand errand{task, name, "", false, false};
  busy_[rank] = &errand;
  changed_.wait(lock, [&] { return errand.done; });
  const std::string text = errand.answer.substr(1);
  if (errand.answer.front() == threw) throw std::runtime_error(fmt::format("rank {}: {}", rank, text));
  return text;
}

/// Sends waiting messages and receives arrived ones. Returns whether there were any.
bool Ranks::pass_messages() {
  bool any = false;
  std::vector<std::pair<int, std::string>> letters;
  {
    const std::lock_guard lock(mutex_);
    for (auto& [rank, errand] : busy_) {
      if (std::exchange(errand->sent, true)) continue;
      letters.emplace_back(rank, std::move(errand->task));
    }
  }
  for (const auto& [rank, task] : letters) {
    world_.mpi().world.send(rank, tag_task, task);
    any = true;
  }
  while (world_.mpi().world.iprobe(boost::mpi::any_source, tag_answer)) {
    std::string answer;
    const int rank = world_.mpi().world.recv(boost::mpi::any_source, tag_answer, answer).source();
    const std::lock_guard lock(mutex_);
    Errand& errand = *busy_.at(rank);
    busy_.erase(rank);
    errand.answer = std::move(answer);
    errand.done = true;
    idle_.push_back(rank);
    changed_.notify_all();
    any = true;
  }
  return any;
}

void Ranks::tell_who_was_at_what() {
  const std::lock_guard lock(mutex_);
  talk("the job is ended from outside");
  if (own_is_busy_) talk(fmt::format("rank 0 was at {}", own_task_));
  for (const auto& [rank, errand] : busy_) talk(fmt::format("rank {} was at {}", rank, errand->name));
}

void Ranks::serve(const std::function<void()>& work) {
  std::signal(SIGTERM, [](int) { is_to_end = 1; });
  std::exception_ptr error;
  std::atomic<bool> finished = false;
  std::thread worker([&] {
    try {
      work();
    } catch (...) {
      error = std::current_exception();
    }
    finished = true;
  });
  for (Patience wait; !finished;) {
    if (is_to_end) {
      tell_who_was_at_what();
      std::_Exit(ended_from_outside);
    }
    if (pass_messages()) wait.reset();
    else wait.wait();
  }
  worker.join();
  for (int rank = 1; rank < world_.size(); ++rank) world_.mpi().world.send(rank, tag_end, std::string());
  if (error) std::rethrow_exception(error);
}

void follow(const Processes& processes, const std::function<Handle()>& start) {
  std::signal(SIGTERM, end_after_rank_0);
  const boost::mpi::communicator& world = processes.mpi().world;
  Handle handle;
  for (Patience wait;;) {
    const auto came = world.iprobe(0, boost::mpi::any_tag);
    if (!came) {
      wait.wait();
      continue;
    }
    wait.reset();
    std::string task, answer;
    world.recv(0, came->tag(), task);
    if (came->tag() == tag_end) return;
    try {
      if (!handle) handle = start();
      answer = answered + handle(task);
    } catch (const std::exception& error) {
      answer = threw + std::string(error.what());
    }
    world.send(0, tag_answer, answer);
  }
}

void in_order_by_ranks(Ranks& ranks, std::size_t count, const std::function<std::string(std::size_t)>& task,
                       const std::function<std::string(std::size_t)>& name,
                       const std::function<bool(std::size_t, const std::string&)>& take) {
  std::mutex mutex;
  std::size_t next = 0, taken = 0;
  bool wanted = true;
  std::map<std::size_t, std::string> answers;  // of tasks whose turn has not come
  std::map<std::size_t, std::exception_ptr> errors;
  const auto work = [&] {
    for (;;) {
      std::unique_lock lock(mutex);
      if (!wanted || !errors.empty() || next == count) return;
      const std::size_t number = next++;
      lock.unlock();
      try {
        std::string answer = ranks.ask(task(number), name(number));
        lock.lock();
        answers.emplace(number, std::move(answer));
        for (auto first = answers.begin(); wanted && first != answers.end() && first->first == taken;
             first = answers.erase(first))
          wanted = take(taken++, first->second);
      } catch (...) {
        if (!lock.owns_lock()) lock.lock();
        errors.emplace(number, std::current_exception());
      }
    }
  };
  std::vector<std::thread> others;
  for (unsigned i = 1; i < ranks.count(); ++i) others.emplace_back(work);
  work();
  for (std::thread& other : others) other.join();
  if (wanted && !errors.empty()) std::rethrow_exception(errors.begin()->second);
}

}  // namespace fathom::cli
