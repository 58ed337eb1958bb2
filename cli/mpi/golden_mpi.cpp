// SPDX-License-Identifier: GPL-3.0-or-later
// mpirun -np N fathom golden generate ...   is replaced by this program. Rank 0 gives the shards one by one to the ranks that ask, and
// works itself; so a slow process makes fewer of them and delays the others only by its last one. All ranks must see the same folder. Each
// shard is made by one process, as without MPI, so the bytes are the same.
#include <fmt/format.h>

#include <algorithm>
#include <boost/mpi/collectives.hpp>
#include <boost/mpi/communicator.hpp>
#include <boost/mpi/environment.hpp>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "cli/args/golden_arguments.hpp"
#include "cli/io/memory.hpp"
#include "cli/io/output.hpp"
#include "kernels/float_environment.hpp"
#include "verify/golden/io/file_error.hpp"
#include "verify/golden/release/generate.hpp"

namespace {

namespace mpi = boost::mpi;
using namespace fathom;

constexpr int tag_request = 1, tag_shard = 2;  // to rank 0, and back
constexpr int no_more = -1;
constexpr auto patience = std::chrono::milliseconds(2);  // between two looks for messages: MPI's own waiting keeps a core busy

void wait_for_message(const mpi::communicator& world, int source, int tag) {
  while (!world.iprobe(source, tag)) std::this_thread::sleep_for(patience);
}

/// The shards that nobody has been given, and the first thing that went wrong; for several threads.
class Stock {
 public:
  explicit Stock(std::vector<std::size_t> shards) : shards_(std::move(shards)) {}
  int take() {
    const std::lock_guard lock(mutex_);
    return failure_.empty() && given_ < shards_.size() ? static_cast<int>(shards_[given_++]) : no_more;
  }
  void fail(const std::string& reason) {
    const std::lock_guard lock(mutex_);
    if (failure_.empty()) failure_ = reason;
  }
  std::string failure() {
    const std::lock_guard lock(mutex_);
    return failure_;
  }
  [[nodiscard]] std::size_t size() const { return shards_.size(); }

 private:
  std::mutex mutex_;
  std::vector<std::size_t> shards_;
  std::size_t given_ = 0;
  std::string failure_;
};

void make(const golden::Generation& generation, int shard) {
  const std::size_t number = static_cast<std::size_t>(shard);
  generation.make({&number, 1});
}

/// Rank 0: answers requests until every other rank has been told that there is no more, while a thread of its own works.
void serve(const mpi::communicator& world, const std::optional<golden::Generation>& generation, Stock& stock) {
  std::thread own([&] {
    try {
      for (int shard = stock.take(); shard != no_more; shard = stock.take()) make(*generation, shard);
    } catch (const std::exception& error) {
      stock.fail(error.what());
    }
  });
  for (int left = world.size() - 1; left > 0;) {
    wait_for_message(world, mpi::any_source, tag_request);
    std::string failure;  // of the shard that this rank was given before; empty: none
    const int rank = world.recv(mpi::any_source, tag_request, failure).source();
    if (!failure.empty()) stock.fail(fmt::format("rank {}: {}", rank, failure));
    const int shard = stock.take();
    world.send(rank, tag_shard, shard);
    if (shard == no_more) --left;
  }
  own.join();
}

/// Every other rank: asks, makes, asks again. What goes wrong is rank 0's to tell.
void work(const mpi::communicator& world, const golden::GenerateOptions& options) {
  std::string failure;
  std::optional<golden::Generation> generation;
  for (;;) {
    world.send(0, tag_request, failure);
    wait_for_message(world, 0, tag_shard);
    int shard = no_more;
    world.recv(0, tag_shard, shard);
    if (shard == no_more) return;
    try {
      if (!generation) generation.emplace(options);
      make(*generation, shard);
      failure.clear();
    } catch (const std::exception& error) {
      failure = error.what();
    }
  }
}

/// Rank 0 from beginning to end; the exit code.
int lead(const mpi::communicator& world, const golden::GenerateOptions& options, const cli::GoldenRequest& request) {
  std::optional<golden::Generation> generation;
  std::vector<std::size_t> wanted;
  std::string failure;
  int code = cli::internal_error;
  try {
    generation.emplace(options);
    for (const std::size_t shard : generation->unfinished())
      if (shard % request.parts == request.part - 1) wanted.push_back(shard);
  } catch (const golden::FolderError& error) {
    failure = error.what();
    code = cli::bad_input;
  } catch (const std::exception& error) {
    failure = error.what();
  }
  Stock stock(wanted);
  if (!failure.empty()) stock.fail(failure);
  serve(world, generation, stock);  // also where there is nothing to do: the others wait for an answer
  failure = stock.failure();
  try {
    if (failure.empty() && !request.is_part) generation->close();
  } catch (const std::exception& error) {
    failure = error.what();
  }
  if (!failure.empty()) {
    cli::talk(failure);
    return code;
  }
  cli::print(fmt::format("{}: {} of {} shards made by {} processes; {}", request.folder, stock.size(), generation->shards().size(),
                         world.size(), request.is_part ? "the part is there" : "the release is complete"));
  return cli::fine;
}

/// Threads for each process, unless the user says: the cores of this machine, shared by the processes on it.
unsigned usual_jobs() {
  const char* const ours = std::getenv("OMPI_COMM_WORLD_LOCAL_SIZE");
  const unsigned processes = ours ? static_cast<unsigned>(std::max(1, std::atoi(ours))) : 1;
  return std::max(1U, std::thread::hardware_concurrency() / processes);
}

int run(int argc, char** argv) {
  mpi::environment environment(argc, argv, mpi::threading::funneled);
  const mpi::communicator world;
  std::vector<std::string> words = {argv + std::min(argc, 1), argv + argc};
  words.insert(words.begin(), "generate");
  const cli::GoldenArguments arguments = cli::parse_golden(words);
  if (!arguments.request) {
    if (world.rank() == 0) cli::talk(arguments.text);
    return cli::bad_input;
  }
  const cli::GoldenRequest& request = *arguments.request;
  std::signal(SIGXFSZ, SIG_IGN);
  golden::GenerateOptions options{request.level, request.seed, request.folder, request.jobs ? request.jobs : usual_jobs(), {}, {}};
  if (world.rank() == 0) return lead(world, options, request);
  work(world, options);
  return cli::fine;
}

}  // namespace

int main(int argc, char** argv) {
  fathom::cli::guard_memory();
  fathom::cli::hold_standard_streams();
  const fathom::kernels::DefaultFloatEnvironment environment;
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    fathom::cli::talk(error.what());
    return fathom::cli::internal_error;
  }
}
