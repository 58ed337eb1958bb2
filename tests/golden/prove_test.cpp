// SPDX-License-Identifier: GPL-3.0-or-later
// Records of every kind that are right are proved, and given again in another way; whatever is
// changed in one, it is refused.
#include "verify/golden/records/prove.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <ostream>
#include <set>

#include "fathom/certificate.hpp"
#include "tests/golden/forged.hpp"
#include "tests/golden/some_recipes.hpp"
#include "verify/check/check.hpp"
#include "verify/golden/records/record.hpp"

namespace fathom::golden {
namespace {

using testing::Json;
using testing::line_with;
using testing::replaced;

// ---- what is asked of every kind alike ----

struct Sample {
  Level level;
  std::size_t step;      ///< every how many recipes are taken
  Recipe sized;          ///< of a family, the first seed
  Recipe one, other;     ///< different bodies
  Recipe plain;          ///< all numbers are binary32: there is no other form
  std::string no_form;   ///< what is said of another one
  std::string mismatch;  ///< what is said of a certificate of other bodies
};

void PrintTo(const Sample& sample, std::ostream* out) { *out << name_of(sample.level); }

class EveryKind : public ::testing::TestWithParam<Sample> {};

INSTANTIATE_TEST_SUITE_P(Golden, EveryKind,
                         ::testing::Values(Sample{Level::L0,
                                                  3,
                                                  {Source::family, "random_ball", 5, 1},
                                                  {Source::family, "random_ball", 5, 1},
                                                  {Source::family, "random_ball", 5, 2},
                                                  {Source::family, "boxes_aligned", 8, 1},
                                                  "source: it does not yield these points",
                                                  "the certificate is about other points"},
                                           Sample{Level::P0,
                                                  7,
                                                  {Source::shape_family, "capsule_hull", 8, 1},
                                                  {Source::shape_family, "cylinders", 8, 2},
                                                  {Source::shape_family, "cylinders", 8, 2},
                                                  {Source::shape_catalogue, "spheres_touching"},
                                                  "source: it has no such form",
                                                  "the certificate is about other bodies"},
                                           Sample{Level::U0,
                                                  3,
                                                  {Source::union_family, "clusters", 4, 1},
                                                  {Source::union_catalogue, "slot_exact_fit"},
                                                  {Source::union_catalogue, "slot_wider"},
                                                  {Source::union_catalogue, "slot_filled"},
                                                  "source: it has no such form",
                                                  "the certificate is about other bodies"},
                                           Sample{Level::C0,
                                                  3,
                                                  {Source::shape_family, "capsule_hull", 8, 1, true},
                                                  {Source::shape_family, "rounded_boxes", 8, 1, true},
                                                  {Source::shape_family, "rounded_boxes", 8, 2, true},
                                                  {Source::family, "boxes_aligned", 8, 1, true},
                                                  "source: it does not yield these points",
                                                  "the certificate is about other bodies"},
                                           Sample{Level::F0,
                                                  3,
                                                  {Source::plane_family, "plane_random", 7, 1},
                                                  {Source::plane_family, "plane_random", 7, 1},
                                                  {Source::plane_family, "plane_random", 7, 2},
                                                  {Source::plane_family, "plane_boxes", 4, 1},
                                                  "source: it has no such form",
                                                  "the certificate is about other bodies"}),
                         [](const auto& info) { return std::string(name_of(info.param.level)); });

TEST_P(EveryKind, WhatIsMadeIsProvedAndGivenAgain) {
  std::set<std::string> statuses, forms;
  std::size_t exact = 0, enclosed = 0;  // of shapes
  for (const Recipe& recipe : testing::some_recipes(GetParam().step, GetParam().level)) {
    for (const Record& record : records_of(recipe)) {
      EXPECT_EQ(faults_of(record.line, record.certificate).value_or(""), "") << record.id;
      for (const Method method : {Method::exact, Method::naive})
        EXPECT_EQ(disagreement_with(method, record.line).value_or(""), "") << record.id;
      EXPECT_EQ(id_in(record.line), record.id);
      EXPECT_EQ(record.csv_row.empty(), GetParam().level != Level::L0 || !record.in_binary64);
      const Json line = Json::parse(record.line), &expected = line["expected"];
      statuses.insert(expected["status"].get<std::string>());
      forms.insert(line["source"]["form"].get<std::string>());
      if (expected.contains("signed_depth")) (expected["signed_depth"].contains("exact") ? exact : enclosed) += 1;
    }
  }
  EXPECT_GE(statuses.size(), 3u);
  EXPECT_EQ(forms.size(), GetParam().level == Level::F0 ? 2u : 3u) << "all of the plane are given in binary64";
  if (GetParam().level != Level::P0) return;
  EXPECT_GT(exact, 50u);
  EXPECT_GT(enclosed, 30u);
}

TEST_P(EveryKind, TheCertificateOfAnotherIsRefused) {
  const Record record = records_of(GetParam().one).front(), other = records_of(GetParam().other).back();
  const std::string& proof = other.certificate;
  EXPECT_NE(faults_of(line_with(record.line, proof), proof).value_or("").find("that of another record"),
            std::string::npos);
  const std::string renamed = replaced(proof, "id " + other.id, "id " + record.id);
  ASSERT_TRUE(fathom_check::verify(renamed).accepted()) << "it is true of other bodies";
  EXPECT_EQ(faults_of(line_with(record.line, renamed), renamed), GetParam().mismatch);
}

TEST_P(EveryKind, AFormThatTheSourceHasNotIsRefused) {
  const Record record = records_of(GetParam().plain).front();
  Json line = Json::parse(record.line);
  line["source"]["form"] = "binary32";
  line["id"] = record.id + ".b32";
  const std::string proof = replaced(record.certificate, "id " + record.id, "id " + record.id + ".b32");
  EXPECT_EQ(faults_of(line_with(line.dump(), proof), proof), GetParam().no_form);
}

TEST_P(EveryKind, ASizeOfFourBillionIsRefused) {
  const Recipe& recipe = GetParam().sized;
  const Record record = records_of(recipe).front();
  Json line = Json::parse(record.line);
  line["source"]["size"] = 4'000'000'000;
  line["id"] = id_of({recipe.source, recipe.name, 4'000'000'000, 1, recipe.contacts});
  EXPECT_EQ(faults_of(line.dump(), record.certificate), "source.size: it is larger than that of any record");
}

// ---- forgers ----

/// One of each status, source and form: ties, flat bodies, a gap that is null.
std::vector<Record> specimens() {
  std::vector<Record> result;
  for (const Recipe& recipe : {Recipe{Source::family, "random_ball", 6, 2},
                               Recipe{Source::family, "exact_ties", 6, 2},
                               Recipe{Source::family, "boxes_posed", 6, 1},
                               Recipe{Source::family, "touching_edge_face", 4, 1},
                               Recipe{Source::family, "random_disjoint", 4, 1},
                               Recipe{Source::family, "solid_polygon", 4, 3},
                               Recipe{Source::real, "fcl-545"},
                               Recipe{Source::shape_family, "capsules", 8, 1},
                               Recipe{Source::shape_family, "rounded_hulls", 8, 4},
                               Recipe{Source::shape_family, "cones", 8, 1},
                               Recipe{Source::shape_family, "shapes_halfspace", 8, 3},
                               Recipe{Source::shape_catalogue, "sphere_centre_on_vertex"},
                               Recipe{Source::shape_catalogue, "spheres_concentric"},
                               Recipe{Source::union_catalogue, "slot_exact_fit"},
                               Recipe{Source::union_catalogue, "gap_of_a_body"},
                               Recipe{Source::catalogue, "contact_facet_facet", 0, 0, true},
                               Recipe{Source::catalogue, "touching_edge_face", 0, 0, true},
                               Recipe{Source::shape_family, "capsule_box", 8, 1, true},
                               Recipe{Source::plane_family, "plane_ties", 6, 2},
                               Recipe{Source::plane_family, "plane_touching", 6, 1},
                               Recipe{Source::plane_family, "plane_rounded", 6, 1}}) {
    result.push_back(records_of(recipe).back());
  }
  return result;
}

std::size_t forged = 0;

void expect_refused(const Record& record, const Json& forgery, const std::string& what) {
  const std::string line = forgery.dump();
  ASSERT_NE(line, record.line) << record.id << ": " << what << " changed nothing";
  static Prover prover;  // it makes the bodies of a record once
  EXPECT_TRUE(prover.faults_of(line, record.certificate)) << record.id << ": " << what;
  ++forged;
}

/// Other values of the same type, and of another.
std::vector<Json> other_values(const Json& value) {
  if (value.is_boolean()) return {!value.get<bool>(), 0};
  if (value.is_number_float()) return {value.get<double>() + 1, "0"};
  if (value.is_number())
    return {value.get<std::uint64_t>() + 1, value.get<std::uint64_t>() + 0.5,
            std::to_string(value.get<std::uint64_t>())};
  if (value.is_null()) return {0, "0", Json::object()};
  if (!value.is_string()) return {};
  const std::string text = value;
  std::string changed = text;
  changed.back() = text.back() == '1' ? '2' : '1';
  return {text + "0", changed, text == "0" ? Json("0/1") : Json()};
}

/// Changes every value below `at`, one at a time; `at` is a place in `forgery`, which is whole
/// again afterwards.
void forge_below(const Record& record, Json& forgery, Json& at, const std::string& path) {
  const Json before = at;
  for (const Json& other : other_values(before)) {
    at = other;
    expect_refused(record, forgery, path + " made " + other.dump());
    at = before;
  }
  if (before.is_structured() && !before.empty()) {
    for (std::size_t i = 0; i < before.size();
         i += before.is_array() ? std::max<std::size_t>(1, before.size() - 1) : 1) {
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
  ASSERT_EQ(all.size(), 21u);
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
  const auto refused = [&record](const std::string& certificate) {
    return faults_of(record.line, certificate).has_value();
  };
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
  const std::size_t claim = weaker.find("claim apart "), directions = weaker.find("directions "),
                    weights = weaker.find("weights_a ");
  weaker = weaker.substr(0, claim) + "claim disjoint\n" + weaker.substr(directions, weights - directions) +
           "end 4 4 1 0 0\n";
  EXPECT_EQ(faults_of(line_with(record.line, weaker), weaker),
            "the certificate does not prove how far the bodies are apart");
}

TEST(Prove, PatchesAndRatesMustBeProvedToo) {
  const Recipe recipe{Source::family, "faces_parallel", 8, 1, true};
  const Record record = records_of(recipe).front();
  EXPECT_TRUE(record.certificate.starts_with("fathom-certificate 4\n"));
  EXPECT_FALSE(faults_of(record.line, record.certificate));
  const auto hulls = std::get<HullPair>(base_bodies(recipe));
  const Answer answer = exact_answer(hulls.a, hulls.b);
  const std::string plain = certificate_text(hulls.a, hulls.b, answer, record.id);
  EXPECT_EQ(faults_of(line_with(record.line, plain), plain), "the certificate has format 1, not 4");
  const ContactGeometry geometry = contact_geometry(hulls.a, hulls.b, answer);
  const std::string fewer =
      certificate_text(hulls.a, hulls.b, answer, geometry, recorded_motions().first(2), record.id);
  EXPECT_EQ(faults_of(line_with(record.line, fewer), fewer),
            "expected.derivatives: the certificate does not prove them");
}

TEST(Prove, TheSecondWaysSeeWhatIsWrongWithContacts) {
  const Pose frame = rigid_pose({1, 2, 3, 4}, {1, 0, mpq_class(1, 2)});
  const RecordBodies bodies = base_bodies({Source::family, "faces_parallel", 8, 2});
  const ContactFacts good = contacts_of(bodies, {}).contacts;
  EXPECT_NO_THROW(insist_on_exchanged(bodies, good, frame, {}));
  EXPECT_NO_THROW(insist_on_clipped(bodies, good));
  ContactFacts cut = good;
  cut.manifold.geometry.patches.front().corners.pop_back();
  EXPECT_THROW(insist_on_exchanged(bodies, cut, frame, {}), NotProved);
  EXPECT_THROW(insist_on_clipped(bodies, cut), NotProved);
  ContactFacts reversed = good;
  auto& rate = std::get<DirectionalDerivative>(reversed.derivatives.back());
  ASSERT_NE(rate.sign(), 0);
  rate.over = -rate.over;
  EXPECT_THROW(insist_on_exchanged(bodies, reversed, frame, {}), NotProved);
}

TEST(Prove, TheConeOfCoresThatTouchIsTheProvedOne) {
  const RecordBodies bodies = base_bodies({Source::family, "touching_vertex_vertex", 8, 1});
  ContactGeometry geometry = contacts_of(bodies, {}).contacts.manifold.geometry;
  const std::optional<OptimalCone> proved = geometry.cone;
  ASSERT_GT(proved.value().rays.size(), 1u);
  EXPECT_NO_THROW(insist_on_cone(geometry, proved));
  EXPECT_THROW(insist_on_cone(geometry, {}), NotProved);
  geometry.cone->rays.pop_back();
  EXPECT_THROW(insist_on_cone(geometry, proved), NotProved);
  geometry.cone.reset();
  EXPECT_THROW(insist_on_cone(geometry, proved), NotProved);
}

TEST(Prove, AnIdStandsForItsOwnPointsOnly) {
  // Another case under this name: all of it true, and its certificate is accepted.
  const Recipe recipe{Source::family, "random_ball", 5, 1}, other{Source::family, "random_ball", 5, 2};
  const auto relabelled_as = [](const Recipe& named, Form form, const Recipe& made) {
    return record_of(named, {form, id_of(named, form), base_bodies(made)});
  };
  const Record honest = relabelled_as(other, Form::given, other),
               relabelled = relabelled_as(recipe, Form::given, other);
  EXPECT_FALSE(faults_of(honest.line, honest.certificate));
  EXPECT_EQ(faults_of(relabelled.line, relabelled.certificate), "source: it does not yield these points");
  // Nothing is rounded to a format that holds it already.
  const Record idle = relabelled_as(recipe, Form::binary64, recipe);
  EXPECT_EQ(faults_of(idle.line, idle.certificate), "source: it does not yield these points");
}

TEST(Prove, IdsAreReadFromWhatTheyCanBeReadFrom) {
  const std::string before = R"({"schema":"fathom/case/1","golden":"fathom/golden/1","id":")";
  EXPECT_EQ(id_in(before + "x\","), "x");
  EXPECT_EQ(id_in(before + "x"), "");
  EXPECT_EQ(id_in(R"({"id":"x"})"), "");
  EXPECT_EQ(id_in(""), "");
}

}  // namespace
}  // namespace fathom::golden
