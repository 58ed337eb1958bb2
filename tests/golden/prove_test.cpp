// SPDX-License-Identifier: GPL-3.0-or-later
// Records that are right are proved; whatever is changed in one, it is refused.
#include "verify/golden/records/prove.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "fathom/certificate.hpp"
#include "tests/golden/forged.hpp"
#include "tests/golden/some_recipes.hpp"
#include "verify/golden/records/record.hpp"

namespace fathom::golden {
namespace {

using testing::Json;
using testing::replaced;

TEST(Prove, WhatIsMadeIsProved) {
  for (const Recipe& recipe : testing::some_recipes(3)) {
    for (const Record& record : records_of(recipe)) EXPECT_EQ(faults_of(record.line, record.certificate).value_or(""), "") << record.id;
  }
}

/// One of each status, source and form: ties, flat bodies, a gap that is null.
std::vector<Record> specimens() {
  std::vector<Record> result;
  for (const Recipe& recipe :
       {Recipe{Source::family, "random_ball", 6, 2}, Recipe{Source::family, "exact_ties", 6, 2},
        Recipe{Source::family, "boxes_posed", 6, 1}, Recipe{Source::family, "touching_edge_face", 4, 1},
        Recipe{Source::family, "random_disjoint", 4, 1}, Recipe{Source::family, "solid_polygon", 4, 3}, Recipe{Source::real, "fcl-545"},
        Recipe{Source::shape_family, "capsules", 8, 1}, Recipe{Source::shape_family, "rounded_hulls", 8, 4},
        Recipe{Source::shape_family, "cones", 8, 1}, Recipe{Source::shape_family, "shapes_halfspace", 8, 3},
        Recipe{Source::shape_catalogue, "sphere_centre_on_vertex"}, Recipe{Source::shape_catalogue, "spheres_concentric"}}) {
    result.push_back(records_of(recipe).back());
  }
  return result;
}

std::size_t forged = 0;

void expect_refused(const Record& record, const Json& forgery, const std::string& what) {
  const std::string line = forgery.dump();
  ASSERT_NE(line, record.line) << record.id << ": " << what << " changed nothing";
  EXPECT_TRUE(faults_of(line, record.certificate)) << record.id << ": " << what;
  ++forged;
}

/// Other values of the same type, and of another.
std::vector<Json> other_values(const Json& value) {
  if (value.is_number())
    return {value.get<std::uint64_t>() + 1, value.get<std::uint64_t>() + 0.5, std::to_string(value.get<std::uint64_t>())};
  if (value.is_null()) return {0, "0", Json::object()};
  if (!value.is_string()) return {};
  const std::string text = value;
  std::string changed = text;
  changed.back() = text.back() == '1' ? '2' : '1';
  return {text + "0", changed, text == "0" ? Json("0/1") : Json()};
}

/// Changes every value below `at`, one at a time; `at` is a place in `forgery`, which is whole again afterwards.
void forge_below(const Record& record, Json& forgery, Json& at, const std::string& path) {
  const Json before = at;
  for (const Json& other : other_values(before)) {
    at = other;
    expect_refused(record, forgery, path + " made " + other.dump());
    at = before;
  }
  if (before.is_structured() && !before.empty()) {
    for (std::size_t i = 0; i < before.size(); i += before.is_array() ? std::max<std::size_t>(1, before.size() - 1) : 1) {
      if (before.is_array()) {
        at.erase(i);
      } else {
        at.erase(std::next(before.begin(), static_cast<std::ptrdiff_t>(i)).key());
      }
      expect_refused(record, forgery, path + " without part " + std::to_string(i));
      at = before;
    }
  }
  if (before.is_array()) {
    at.push_back(before.empty() ? Json("0") : before.front());
    expect_refused(record, forgery, path + " with one more");
    at = before;
  }
  if (before.is_object()) {
    at["more"] = 1;
    expect_refused(record, forgery, path + " with another field");
    at = before;
  }
  if (!at.is_structured()) return;
  for (auto part = at.begin(); part != at.end(); ++part) {
    const std::string name = at.is_object() ? part.key() : std::to_string(part - at.begin());
    forge_below(record, forgery, *part, path + "/" + name);
  }
}

TEST(Prove, EveryFieldThatIsForgedIsRefused) {
  const std::vector<Record> all = specimens();
  ASSERT_EQ(all.size(), 13u);
  for (const Record& record : all) {
    Json forgery = Json::parse(record.line);
    ASSERT_EQ(forgery.dump(), record.line) << "what is not changed stays as it was";
    ASSERT_FALSE(faults_of(forgery.dump(), record.certificate));
    forge_below(record, forgery, forgery, "");
    EXPECT_EQ(forgery.dump(), record.line);
  }
  EXPECT_GT(forged, 3000u);
}

TEST(Prove, OtherFormsOfTheSameRecordAreRefused) {
  const Record record = records_of({Source::family, "random_ball", 5, 1}).front();
  const std::string& line = record.line;
  const auto refused = [&record](const std::string& text) { return faults_of(text, record.certificate).has_value(); };
  EXPECT_FALSE(refused(line));
  EXPECT_TRUE(refused(""));
  EXPECT_TRUE(refused("{}"));
  EXPECT_TRUE(refused("[" + line + "]"));
  EXPECT_TRUE(refused(line + " "));
  EXPECT_TRUE(refused(line + line));
  EXPECT_TRUE(refused(line + "\n"));
  EXPECT_TRUE(refused(line.substr(0, line.size() - 1)));
  EXPECT_TRUE(refused(R"({"schema":"fathom/case/1",)" + line.substr(1))) << "a field twice";
  EXPECT_TRUE(refused(nlohmann::json::parse(line).dump())) << "fields in another order";
  for (std::size_t cut = 0; cut < line.size(); cut += 37) EXPECT_TRUE(refused(line.substr(0, cut)));
}

TEST(Prove, CertificatesMustBeThoseOfTheRecord) {
  const Record record = records_of({Source::family, "boxes_aligned", 8, 1}).front();
  const std::string& proof = record.certificate;
  const auto refused = [&record](const std::string& certificate) { return faults_of(record.line, certificate).has_value(); };
  EXPECT_FALSE(refused(proof));
  EXPECT_TRUE(refused(""));
  EXPECT_TRUE(refused(proof + proof));
  EXPECT_TRUE(refused("# a remark\n" + proof)) << "its sum is another";
  EXPECT_TRUE(refused(proof.substr(0, proof.size() - 1)));
  EXPECT_TRUE(refused(records_of({Source::family, "random_ball", 5, 2}).front().certificate));
  EXPECT_TRUE(refused(replaced(proof, "id " + record.id, "id " + record.id + ".b64")));
  EXPECT_TRUE(refused(replaced(proof, " all\n", " some\n")));
  EXPECT_TRUE(refused(replaced(proof, "claim depth ", "claim depth 1")));
}

TEST(Prove, TheDistanceMustBeProvedToo) {
  const Recipe recipe{Source::family, "random_disjoint", 4, 1};
  const Record record = records_of(recipe).front();
  EXPECT_TRUE(record.certificate.starts_with("fathom-certificate 2\n"));
  EXPECT_NE(record.certificate.find("\nclaim apart "), std::string::npos);
  // The certificate of format 1, with its own sum: it says that they are disjoint.
  std::string weaker = record.certificate;
  weaker[weaker.find('2')] = '1';
  const std::size_t claim = weaker.find("claim apart "), directions = weaker.find("directions "), weights = weaker.find("weights_a ");
  weaker = weaker.substr(0, claim) + "claim disjoint\n" + weaker.substr(directions, weights - directions) + "end 4 4 1 0 0\n";
  EXPECT_EQ(faults_of(testing::line_with(record.line, weaker), weaker), "the certificate does not prove how far the bodies are apart");
}

TEST(Prove, AnIdStandsForItsOwnPointsOnly) {
  // Another case under this name: all of it true, and its certificate is accepted.
  const Recipe recipe{Source::family, "random_ball", 5, 1}, other{Source::family, "random_ball", 5, 2};
  Case points = base_case(other);
  points.id = id_of(recipe);
  const Record honest = record_of(other, Form::given, base_case(other)), relabelled = record_of(recipe, Form::given, points);
  EXPECT_FALSE(faults_of(honest.line, honest.certificate));
  EXPECT_EQ(faults_of(relabelled.line, relabelled.certificate), "source: it does not yield these points");
  // Nor does a name ask for unbounded work.
  const Recipe enormous{Source::family, "random_ball", 4'000'000'000, 1};
  points.id = id_of(enormous);
  const Record hostile = record_of(enormous, Form::given, points);
  EXPECT_EQ(faults_of(hostile.line, hostile.certificate), "source.size: it is larger than that of any record");
  // Nothing is rounded to a format that holds it already.
  points = base_case(recipe);
  points.id = id_of(recipe, Form::binary64);
  const Record idle = record_of(recipe, Form::binary64, points);
  EXPECT_EQ(faults_of(idle.line, idle.certificate), "source: it does not yield these points");
}

TEST(Prove, IdsAreReadFromWhatTheyCanBeReadFrom) {
  const std::string before = R"({"schema":"fathom/case/1","golden":"fathom/golden/1","id":")";
  EXPECT_EQ(id_in(before + "x\","), "x");
  EXPECT_EQ(id_in(before + "x"), "");
  EXPECT_EQ(id_in(R"({"id":"x"})"), "");
  EXPECT_EQ(id_in(""), "");
  const Record record = records_of({Source::family, "random_ball", 5, 1}).front();
  EXPECT_EQ(id_in(record.line), record.id);
  const Record shapes = records_of({Source::shape_family, "spheres", 8, 1}).front();
  EXPECT_EQ(id_in(shapes.line), shapes.id);
}

}  // namespace
}  // namespace fathom::golden
