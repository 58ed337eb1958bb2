// SPDX-License-Identifier: GPL-3.0-or-later
// What stands between C and the rest: handles, messages, and the one place where exceptions become
// codes.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <mutex>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "fathom/answer.hpp"
#include "fathom/fathom.h"
#include "fathom/files.hpp"
#include "fathom/prepared.hpp"
#include "kernels/float_environment.hpp"
#include "reference/output/answer_json.hpp"

struct fathom_body {
  std::shared_ptr<const fathom::Body> body;
};

struct fathom_prepared {
  fathom::Prepared prepared;
};

namespace fathom::c {

/// Where the bodies of an answer touch, found when somebody asks, once, whatever threads do.
class LaterManifold {
 public:
  const output::Manifold& of(const fathom_answer& asked);

 private:
  std::mutex lock_;
  std::optional<output::Manifold> found_;
};

}  // namespace fathom::c

struct fathom_answer {
  std::shared_ptr<const fathom::Body> a, b;
  fathom::Answer answer;
  std::optional<std::size_t> listed;  ///< how many optima were asked for
  std::unique_ptr<fathom::c::LaterManifold> manifold = std::make_unique<fathom::c::LaterManifold>();
};

namespace fathom::c {

/// The answer has no such part.
struct Absence : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// What fathom_last_error returns to this thread. Cut where it is too long.
void set_message(std::string_view message) noexcept;

/// Throws std::invalid_argument that names what is missing, unless the pointer is there.
void require(const void* pointer, const char* name);

/// Throws std::invalid_argument unless the struct is there, and as large as that of this version.
template <class Struct>
void require_struct(const Struct* given, const char* name) {
  require(given, name);
  if (given->size != sizeof(Struct))
    throw std::invalid_argument(std::string(name) + ": not set by its init function of this version");
}

/// Throws std::invalid_argument that begins with the name unless all of these numbers are finite.
void require_finite(const double* numbers, std::size_t count, const std::string& name);

/// v and w; null of a body at rest. Throws as require_finite.
Twist twist_from(const double* numbers, const std::string& name);

/// Twelve numbers as a matrix. Throws std::invalid_argument that begins with the name unless they
/// are finite.
PoseBinary64 pose_from(const double* numbers, const std::string& name);

/// The text as the caller frees it.
char* text_for_caller(std::string_view text);

Decimals decimals_from(int decimals);

/// Throws std::invalid_argument that begins with the name if the body is a union of pieces.
void require_convex(const Body& body, const std::string& name);

/// Throws std::invalid_argument unless there are from 1 to 2^31 of `what`.
void require_count(std::size_t count, const char* what);

void require_at_most(std::size_t count, const char* what);

/// Throws std::invalid_argument that begins with `what` unless `index` is below `count`.
void require_below(std::size_t index, std::size_t count, const std::string& what, const std::string& of);

fathom_body handle(Body body);

/// Does the work in the default floating-point environment and returns its code; whatever it throws
/// becomes one, with a message.
template <class Work>
int guarded(Work work) noexcept {
  const kernels::DefaultFloatEnvironment environment;
  const auto failed = [](int code, std::string_view message) {
    set_message(message);
    return code;
  };
  try {
    work();
    return failed(FATHOM_OK, "");
  } catch (const Absence& error) {
    return failed(FATHOM_ABSENT, error.what());
  } catch (const Interrupted&) {
    return failed(FATHOM_INTERRUPTED, "interrupted");
  } catch (const std::invalid_argument& error) {
    return failed(FATHOM_BAD_INPUT, error.what());
  } catch (const InputError& error) {
    return failed(FATHOM_BAD_INPUT, error.what());
  } catch (const std::bad_alloc&) {
    return failed(FATHOM_OUT_OF_MEMORY, "out of memory");
  } catch (const std::exception& error) {
    return failed(FATHOM_INTERNAL, error.what());
  } catch (...) {
    return failed(FATHOM_INTERNAL, "a fault of fathom");
  }
}

/// Sets the handle to what `make` returns, or to NULL.
template <class Handle, class Make>
int make_handle(Handle** handle, Make make) noexcept {
  if (handle) *handle = nullptr;
  return guarded([&] {
    require(handle, "the place for the result");
    *handle = std::make_unique<Handle>(make()).release();
  });
}

/// Sets the text to what `make` returns, or to NULL.
template <class Make>
int make_text(char** text, Make make) noexcept {
  if (text) *text = nullptr;
  return guarded([&] {
    require(text, "the place for the text");
    *text = text_for_caller(make());
  });
}

/// Asks the caller's function, if there is one.
class CallersMonitor final : public Monitor {
 public:
  explicit CallersMonitor(const fathom_options& options) : options_(options) {}
  void report(std::string_view, double) override {}
  [[nodiscard]] bool stopped() override { return options_.stop && options_.stop(options_.caller) != 0; }

 private:
  const fathom_options& options_;
};

/// The options that are given, or the usual ones. Throws std::invalid_argument.
fathom_options options_from(const fathom_options* options);

/// One line of JSON with all that is shown.
std::string json_of(const fathom_answer& asked, const std::string& id, std::optional<output::Manifold> manifold = {});

/// In lowest terms: "3/5", "-sqrt(1/3)".
std::string surd_text(const Surd& value);
/// The three of them, joined by blanks.
std::string coordinates_text(const SurdPoint& values);

/// To nearest.
void copy_numbers(const std::array<double, 3>& from, double* to);

/// FATHOM_PENETRATING and so on.
int status_of(const std::optional<Status>& status);

/// A signed depth, rounded: `nearest` is NaN if bounds leave it open.
struct RoundedDepth {
  double nearest, low, high;
};
RoundedDepth rounded(const Answer& answer);

}  // namespace fathom::c
