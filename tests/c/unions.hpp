// SPDX-License-Identifier: GPL-3.0-or-later
// Unions of convex pieces as handles of C, for tests.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "fathom/union.hpp"
#include "tests/c/handles.hpp"

namespace fathom::testing {

inline BodyHandle union_of(const std::vector<BodyHandle>& pieces) {
  std::vector<fathom_body*> given;
  for (const BodyHandle& piece : pieces) given.push_back(piece.get());
  fathom_body* body = nullptr;
  EXPECT_EQ(fathom_body_from_pieces(given.data(), given.size(), &body), FATHOM_OK) << fathom_last_error();
  return BodyHandle(body);
}

inline BodyHandle union_of(const Pieces& pieces) {
  std::vector<BodyHandle> handles;
  for (const std::vector<Point>& piece : pieces) handles.push_back(exact_body_of(piece));
  return union_of(handles);
}

inline BodyHandle box_at(double x, double y, double z, double side_x, double side_y, double side_z) {
  const double pose[12] = {side_x, 0, 0, x, 0, side_y, 0, y, 0, 0, side_z, z};
  fathom_body* body = nullptr;
  EXPECT_EQ(fathom_body_moved(body_of(cube_at(0)).get(), pose, &body), FATHOM_OK) << fathom_last_error();
  return BodyHandle(body);
}

/// Two walls and a floor, in the shape of a U; and a bar as wide as the slot between the walls.
inline BodyHandle block() {
  std::vector<BodyHandle> pieces;
  pieces.push_back(box_at(0, 0, 0, 2, 4, 4));
  pieces.push_back(box_at(4, 0, 0, 2, 4, 4));
  pieces.push_back(box_at(2, 0, 0, 2, 4, 1));
  return union_of(pieces);
}
inline BodyHandle bar() { return box_at(1, 1, 2, 2, 2, 4); }

inline std::string certificate_of(const AnswerHandle& answer, const char* id) {
  char* text = nullptr;
  EXPECT_EQ(fathom_answer_certificate(answer.get(), id, nullptr, &text), FATHOM_OK) << fathom_last_error();
  return taken(text);
}

inline std::string json_of(const AnswerHandle& answer, const char* id) {
  char* text = nullptr;
  EXPECT_EQ(fathom_answer_json(answer.get(), id, &text), FATHOM_OK) << fathom_last_error();
  return taken(text);
}

}  // namespace fathom::testing
