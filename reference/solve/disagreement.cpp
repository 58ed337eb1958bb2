// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/solve/disagreement.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "fathom/numbers.hpp"

namespace fathom::solve {
namespace {

std::string shown(bool value) { return value ? "yes" : "no"; }
std::string shown(std::size_t count) { return std::to_string(count); }
std::string shown(Status status) { return std::string(name(status)); }
std::string shown(const mpq_class& value) { return exact_text(value); }
std::string shown(const Vector& v) { return fmt::format("({}, {}, {})", v.x.get_str(), v.y.get_str(), v.z.get_str()); }
std::string shown(const Point& p) {
  return fmt::format("({}, {}, {})", exact_text(p.x), exact_text(p.y), exact_text(p.z));
}
std::string shown(const Contact& contact) {
  return fmt::format("{}: points {} of A, {} of B", name(contact.kind), fmt::join(contact.a, " "),
                     fmt::join(contact.b, " "));
}
std::string shown(const std::optional<Witness>& witness) {
  return witness ? fmt::format("{} and {}", shown(witness->a), shown(witness->b)) : "none";
}

/// Keeps the first difference.
class Comparison {
 public:
  template <class Value>
  void same(const std::string& field, const Value& x, const Value& y) {
    if (!found_ && !(x == y)) found_ = fmt::format("{}: {} and {}", field, shown(x), shown(y));
  }
  [[nodiscard]] bool differs() const { return found_.has_value(); }
  std::optional<std::string> take() { return std::move(found_); }

 private:
  std::optional<std::string> found_;
};

void compare(Comparison& comparison, const std::vector<Optimum>& x, const std::vector<Optimum>& y) {
  comparison.same("number of optima listed", x.size(), y.size());
  for (std::size_t i = 0; i < x.size() && !comparison.differs(); ++i) {
    const std::string place = fmt::format("optima[{}].", i);
    comparison.same(place + "direction", x[i].direction, y[i].direction);
    comparison.same(place + "translation", x[i].translation(), y[i].translation());
    comparison.same(place + "contact", x[i].contact, y[i].contact);
  }
}

void compare(Comparison& comparison, const Distance& x, const Distance& y) {
  comparison.same("distance.squared", x.squared, y.squared);
  comparison.same("distance.translation", x.translation, y.translation);
  comparison.same("distance.witness", std::optional(x.witness), std::optional(y.witness));
  comparison.same("distance.contact", x.contact, y.contact);
}

}  // namespace

std::optional<std::string> disagreement(const Depth& x, const Depth& y) {
  Comparison comparison;
  comparison.same("status", x.status(), y.status());
  comparison.same("flat_a", x.flat_a, y.flat_a);
  comparison.same("flat_b", x.flat_b, y.flat_b);
  comparison.same("squared", x.squared(), y.squared());
  comparison.same("number of optima", x.optima_count(), y.optima_count());
  compare(comparison, x.optima(), y.optima());
  if (comparison.differs()) return comparison.take();
  comparison.same("direction", x.direction(), y.direction());
  comparison.same("witness", x.witness(), y.witness());
  if (x.distance()) compare(comparison, *x.distance(), *y.distance());
  return comparison.take();
}

std::optional<Method> second_method(std::string_view word) {
  for (const Method method : {Method::exact, Method::naive})
    if (word == name(method)) return method;
  return std::nullopt;
}

}  // namespace fathom::solve
