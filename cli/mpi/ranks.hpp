// SPDX-License-Identifier: GPL-3.0-or-later
// The processes of an MPI job: rank 0 distributes tasks, which are texts, and every rank answers
// one at a time, by a text. Slow ranks get fewer tasks. All messages pass through one thread of
// each process.
#pragma once

#include <condition_variable>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace fathom::cli {

/// This process as a member of an MPI job; MPI is initialised while it exists.
class Processes {
 public:
  Processes(int& argc, char**& argv);
  ~Processes();
  Processes(const Processes&) = delete;
  Processes& operator=(const Processes&) = delete;

  [[nodiscard]] int rank() const;
  [[nodiscard]] int size() const;

  struct Mpi;
  [[nodiscard]] Mpi& mpi() const { return *mpi_; }

 private:
  std::unique_ptr<Mpi> mpi_;
};

/// Answers a task. An exception that it throws is rethrown by Ranks::ask.
using Handle = std::function<std::string(const std::string& task)>;

/// The side of rank 0.
class Ranks {
 public:
  /// `own` answers the tasks of rank 0 itself.
  Ranks(const Processes& world, Handle own);

  [[nodiscard]] unsigned count() const { return static_cast<unsigned>(world_.size()); }

  /// Returns the answer of the first free rank, and waits for it. Any thread may call it while
  /// `serve` runs. Throws std::runtime_error with "rank 2: " and the message of that rank's
  /// exception, or rethrows that of `own`. `name` describes the task in the message that is printed
  /// if the job is ended meanwhile.
  std::string ask(const std::string& task, const std::string& name);

  /// Runs `work` on a thread of its own and passes its messages; then dismisses all ranks. Rethrows
  /// exceptions of `work`. If the job is ended from outside, as by mpirun when a rank dies, prints
  /// which rank was at which task, and ends the process.
  void serve(const std::function<void()>& work);

 private:
  struct Errand {
    std::string task, name, answer;
    bool sent = false, done = false;
  };
  bool pass_messages();
  void tell_who_was_at_what();

  const Processes& world_;
  Handle own_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<int> idle_;
  std::map<int, Errand*> busy_;  // by rank
  std::string own_task_;         // the name of rank 0's current task
  bool own_is_busy_ = false;
};

/// The side of every other rank: answers tasks until it is dismissed. Calls `start` when the first
/// task arrives.
void follow(const Processes& world, const std::function<Handle()>& start);

/// Has tasks 0, 1, ... below `count` answered by all ranks at once, and passes the answers to
/// `take` in order, one at a time, until it returns false. Rethrows the exception of the lowest
/// task that failed.
void in_order_by_ranks(Ranks& ranks, std::size_t count, const std::function<std::string(std::size_t)>& task,
                       const std::function<std::string(std::size_t)>& name,
                       const std::function<bool(std::size_t, const std::string&)>& take);

}  // namespace fathom::cli
