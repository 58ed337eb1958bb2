// SPDX-License-Identifier: GPL-3.0-or-later
// The processes of an MPI job: rank 0 leads and hands out tasks, which are texts, and every rank
// answers one at a time, by a text. Who is slow gets fewer. All messages pass through one thread of
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

/// This process as one of an MPI job: MPI runs while it exists.
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

/// Answers a task. What it throws becomes an error of whoever asked.
using Handle = std::function<std::string(const std::string& task)>;

/// Rank 0's side.
class Ranks {
 public:
  /// `own` answers what falls to rank 0 itself.
  Ranks(const Processes& world, Handle own);

  [[nodiscard]] unsigned count() const { return static_cast<unsigned>(world_.size()); }

  /// Returns the answer of the first rank that is free. Any thread may call it while `serve` runs;
  /// it waits. Throws std::runtime_error with "rank 2: " and what the rank's handle threw, or what
  /// the own one threw. `name` is what is told of the task if the job is ended while a rank is at
  /// it.
  std::string ask(const std::string& task, const std::string& name);

  /// Runs `work` on a thread of its own and passes its messages; then dismisses all ranks. Rethrows
  /// what `work` throws. If the job is ended from outside, as mpirun does when a rank dies, says
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
  std::string own_task_;         // the name of what rank 0 is at
  bool own_is_busy_ = false;
};

/// The side of every other rank: answers until it is dismissed. `start` is called with the first
/// task that comes.
void follow(const Processes& world, const std::function<Handle()>& start);

/// Has tasks 0, 1, ... below `count` answered by all ranks at once, and takes the answers in order,
/// one at a time; `take` returns false if it wants no more. Rethrows the first exception of the
/// lowest task.
void in_order_by_ranks(Ranks& ranks, std::size_t count, const std::function<std::string(std::size_t)>& task,
                       const std::function<std::string(std::size_t)>& name,
                       const std::function<bool(std::size_t, const std::string&)>& take);

}  // namespace fathom::cli
