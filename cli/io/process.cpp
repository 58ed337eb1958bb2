// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/io/process.hpp"

#include <gmp.h>
#include <sys/resource.h>
#include <tbb/task_arena.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <climits>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <functional>
#include <mutex>
#include <new>
#include <optional>
#include <string_view>

#include "cli/io/output.hpp"

namespace {

using namespace std::string_view_literals;

constexpr std::size_t reserve_size = std::size_t{8} << 20, alignment = alignof(std::max_align_t);
alignas(alignment) char reserve[reserve_size];  // untouched pages take no memory
std::mutex taking;
std::size_t reserve_used = 0;
std::atomic<std::size_t> reserve_blocks = 0;
thread_local bool must_throw = false;  // GMP was served from the reserve
bool is_guarded = false;

[[noreturn]] void leave_without_memory() {
  for (const std::string_view text : {isatty(STDERR_FILENO) == 1 ? "\r\033[K"sv : ""sv, "fathom: out of memory\n"sv})
    if (write(STDERR_FILENO, text.data(), text.size()) < 0) break;
  _exit(fathom::cli::internal_error);
}

bool is_in_reserve(const void* block) {
  return !std::less<>()(static_cast<const char*>(block), reserve) &&
         std::less<>()(static_cast<const char*>(block), reserve + reserve_size);
}

/// Allocates consecutive blocks; starts again from the beginning when all have been freed.
void* take_from_reserve(std::size_t size) {
  const std::lock_guard lock(taking);
  if (reserve_blocks == 0) reserve_used = 0;
  if (size > reserve_size - reserve_used) leave_without_memory();
  void* const block = reserve + reserve_used;
  reserve_used += std::min((size + alignment - 1) / alignment * alignment, reserve_size - reserve_used);
  ++reserve_blocks;
  must_throw = true;
  return block;
}

/// The least size of a block. GMP allocates one word first, and soon two or three: in a block of
/// this size a number can grow in place. Blocks from before `guard_memory` belong to constants,
/// which never grow.
constexpr std::size_t least_block = 64;

void* allocate(std::size_t size) {
  size = std::max(size, least_block);
  void* const block = std::malloc(size);
  return block ? block : take_from_reserve(size);
}

void release(void* block, std::size_t) {
  if (is_in_reserve(block)) --reserve_blocks;
  else std::free(block);
}

void* reallocate(void* old, std::size_t old_size, std::size_t size) {
  if (std::max(old_size, size) <= least_block) return old;
  size = std::max(size, least_block);
  const bool reserved = is_in_reserve(old);
  if (!reserved) {
    if (void* const block = std::realloc(old, size)) return block;
  }
  void* const block = reserved ? allocate(size) : take_from_reserve(size);
  std::memcpy(block, old, size < old_size ? size : old_size);
  release(old, old_size);
  return block;
}

[[noreturn]] void terminated() {
  try {
    if (std::current_exception()) throw;
  } catch (const std::bad_alloc&) {
    leave_without_memory();
  } catch (...) {
  }
  std::abort();
}

void* checked(void* block) {
  if (block && !must_throw) return block;
  if (!is_guarded) leave_without_memory();  // handlers of exceptions are not installed yet
  std::free(block);
  must_throw = false;
  throw std::bad_alloc();
}

std::size_t at_least_one(std::size_t size) { return size > 0 ? size : 1; }

[[maybe_unused]] void* aligned(std::size_t size, std::align_val_t to) {
  const auto step = static_cast<std::size_t>(to);
  if (size > PTRDIFF_MAX) throw std::bad_alloc();
  return checked(std::aligned_alloc(step, (at_least_one(size) + step - 1) / step * step));
}

}  // namespace

// AddressSanitizer has operators of its own; g++ and clang indicate it in different ways. operator
// delete is not replaced: it is free().
#ifdef __SANITIZE_ADDRESS__
#define FATHOM_ADDRESS_SANITIZER 1
#elif defined(__has_feature)
#define FATHOM_ADDRESS_SANITIZER __has_feature(address_sanitizer)
#else
#define FATHOM_ADDRESS_SANITIZER 0
#endif
#if !FATHOM_ADDRESS_SANITIZER
void* operator new(std::size_t size) { return checked(std::malloc(at_least_one(size))); }
void* operator new[](std::size_t size) { return checked(std::malloc(at_least_one(size))); }
void* operator new(std::size_t size, std::align_val_t to) { return aligned(size, to); }
void* operator new[](std::size_t size, std::align_val_t to) { return aligned(size, to); }
#endif

namespace fathom::cli {

void guard_memory() {
  mp_set_memory_functions(allocate, reallocate, release);
  std::set_terminate(terminated);
  is_guarded = true;
}

namespace {

/// Returns the folder of this program, with a slash, or "" if it is unknown.
std::string own_folder() {
  std::string path(PATH_MAX, '\0');
  const ssize_t length = readlink("/proc/self/exe", path.data(), path.size());
  path.resize(length > 0 ? static_cast<std::size_t>(length) : 0);
  return path.substr(0, path.rfind('/') + 1);
}

}  // namespace

void become(const std::string& program, std::vector<std::string> words) {
  words.insert(words.begin(), program);
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const std::string folder = own_folder();
  if (!folder.empty()) execv((folder + program).c_str(), arguments.data());
  execvp(program.c_str(), arguments.data());
}

void look_here_first() {
  const std::string folder = own_folder();
  const char* const path = std::getenv("PATH");
  if (!folder.empty()) setenv("PATH", (folder + (path ? ":" + std::string(path) : "")).c_str(), 1);
}

namespace {

constexpr rlim_t of_a_thread = rlim_t{128}
                               << 20;  // bytes of address space for each thread: its stack, its heap, and its items

std::optional<rlim_t> limit_of_addresses() {
  rlimit limit{};
  const bool limited = ::getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
  return limited ? std::optional(limit.rlim_cur) : std::nullopt;
}

}  // namespace

unsigned usual_threads() {
  return limit_of_addresses() ? 1 : static_cast<unsigned>(tbb::this_task_arena::max_concurrency());
}

unsigned possible_threads(unsigned asked) {
  const std::optional<rlim_t> limit = limit_of_addresses();
  return limit ? static_cast<unsigned>(std::clamp<rlim_t>(*limit / of_a_thread, 1, asked)) : asked;
}

}  // namespace fathom::cli
