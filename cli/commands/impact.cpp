// SPDX-License-Identifier: GPL-3.0-or-later
// fathom impact --from POSE --to POSE [--b-from POSE --b-to POSE] A B | CASES.jsonl | -
// When two bodies that turn and move meet first. As text and as JSON (impact.schema.json).
#include "fathom/impact.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>

#include "cli/commands/command.hpp"
#include "cli/commands/replies.hpp"
#include "cli/io/output.hpp"
#include "cli/output/text_rows.hpp"
#include "reference/files/case_fields.hpp"
#include "reference/output/json_values.hpp"

namespace fathom::cli {
namespace {

constexpr const char* impact_schema = "fathom/impact/1";

struct ImpactRequest : BodiesRequest {
  explicit ImpactRequest(const Given& given)
      : BodiesRequest(given),
        form(given),
        a{given.value("--from"), given.value("--to")},
        b{given.value("--b-from"), given.value("--b-to")},
        certificate(given.text("--certificate")) {
    options.bits = given.integer<unsigned>("--bits").value_or(options.bits);
    options.delta = given.number("--delta");
  }

  struct Ends {
    std::optional<std::string> from, to;  ///< as typed
  };
  AnswerForm form;
  Ends a, b;
  std::string certificate;  ///< a file, or for a stream a folder; empty: none
  ImpactOptions options;
};

/// A case with its motions, as they were answered.
struct MovedCase {
  const Case& input;
  files::MotionsOfCase motions;

  [[nodiscard]] Impact impact(ImpactOptions options, Monitor& monitor) const {
    options.monitor = &monitor;
    return first_contact(input.a.points, motions.a, input.b.points, motions.b, options);
  }
  [[nodiscard]] std::string certificate(const Impact& impact, Monitor& monitor) const {
    return certificate_text(input.a.points, motions.a, input.b.points, motions.b, impact, input.id, &monitor);
  }
};

RigidMotion typed_motion_of(const ImpactRequest& request, const ImpactRequest::Ends& ends, bool of_a) {
  std::string fault;
  const auto pose = [&](const std::optional<std::string>& text, const std::string& option) {
    return text ? std::optional(asked_pose(*text, option, request.decimals, false)) : std::nullopt;
  };
  const std::optional<files::GivenPose> from = pose(ends.from, of_a ? "--from" : "--b-from"),
                                        to = pose(ends.to, of_a ? "--to" : "--b-to");
  RigidMotion motion = files::motion_between(from, to, fault);
  return fault.empty() ? motion : throw InputError(of_a ? "--from, --to" : "--b-from, --b-to", 0, fault);
}

files::MotionsOfCase asked_motions(const ImpactRequest& request, const AskedCase& asked) {
  if (asked.text.empty())
    return {typed_motion_of(request, request.a, true), typed_motion_of(request, request.b, false)};
  std::string fault;
  files::MotionsOfCase motions = files::read_motions(asked.text, fault);
  return fault.empty() ? motions : throw InputError(asked.input.id, 0, fault);
}

std::string time_text(const mpq_class& t, const AnswerForm& form) {
  return form.exact ? exact_text(t) : root_text(t * t);
}

/// Returns how many pieces of time there are, and of which kinds.
std::string pieces_text(const Impact& impact) {
  std::size_t near = 0;
  for (const ImpactPiece& piece : impact.pieces) near += piece.near.has_value();
  std::string text = fmt::format("{}", impact.pieces.size() - near);
  return near == 0 ? text : fmt::format("{}, and {} in which the bodies may touch", text, near);
}

/// The greatest distance at the end of a near miss.
mpq_class gap_of(const Impact& impact) {
  mpq_class gap;
  for (const ImpactPiece& piece : impact.pieces)
    if (piece.near) gap = std::max(gap, piece.near->gap);
  return gap;
}

std::string heading_of(const Impact& impact) {
  if (!impact.beginning) return std::string(name(impact.status));
  return fmt::format("{} {}", name(impact.beginning->status()), name(impact.status));
}

/// Returns several lines, or one; without the last newline.
std::string impact_block(const Impact& impact, const AnswerForm& form) {
  std::vector<Row> rows;
  if (impact.beginning) {
    rows.emplace_back("depth", root_text(impact.beginning->squared()));
    return aligned(heading_of(impact), rows);
  }
  if (impact.contact) {
    const FirstContact& contact = *impact.contact;
    rows.emplace_back("apart until", time_text(contact.t0, form));
    rows.emplace_back("in contact at", time_text(contact.t1, form));
    rows.emplace_back("point", place_text(contact.point, form));
    add_points(rows, "in the frames", place_text(contact.in_a, form), place_text(contact.in_b, form));
    rows.emplace_back("normal", way_text(contact.normal, form));
    rows.emplace_back("contact", contact_text(contact.contact));
  }
  if (impact.status == ImpactStatus::grazing)
    rows.emplace_back("gap at most",
                      form.exact ? exact_text(gap_of(impact)) : root_text(gap_of(impact) * gap_of(impact)));
  rows.emplace_back("planes", pieces_text(impact));
  return aligned(heading_of(impact), rows);
}

std::string impact_line(const std::string& id, const Impact& impact, const AnswerForm& form) {
  std::vector<std::string> parts{heading_of(impact)};
  if (impact.beginning) parts.push_back("depth " + root_text(impact.beginning->squared()));
  if (impact.contact) {
    parts.push_back("apart until " + time_text(impact.contact->t0, form));
    parts.push_back("in contact at " + time_text(impact.contact->t1, form));
    parts.push_back("normal " + way_text(impact.contact->normal, form));
    parts.emplace_back(name(impact.contact->contact.kind));
  }
  if (gap_of(impact) != 0) parts.push_back("planes " + pieces_text(impact));
  return case_line(id, parts);
}

Json contact_json(const FirstContact& contact) {
  return {{"t0", output::number(contact.t0)},
          {"t1", output::number(contact.t1)},
          {"point", output::exact(contact.point)},
          {"in_a", output::exact(contact.in_a)},
          {"in_b", output::exact(contact.in_b)},
          {"normal", output::exact(contact.normal)},
          {"contact", output::contact_object(contact.contact)},
          {"weights", {{"a", output::weights_array(contact.a)}, {"b", output::weights_array(contact.b)}}}};
}

Json piece_json(const ImpactPiece& piece) {
  Json directions;
  if (piece.plane) {
    directions = Json::array({output::exact(piece.plane->first)});
    if (piece.plane->kind == MovingPlane::Kind::of_edges) directions.push_back(output::exact(piece.plane->second));
  }
  return {{"until", exact_text(piece.until)},
          {"plane", piece.plane ? Json(name(piece.plane->kind)) : Json()},
          {"directions", std::move(directions)},
          {"gap", piece.near ? Json(exact_text(piece.near->gap)) : Json()}};
}

Json motion_json_of(const RigidMotion& motion) {
  const auto quaternion = [](const Quaternion& q) {
    return Json::array({exact_text(q.w), exact_text(q.x), exact_text(q.y), exact_text(q.z)});
  };
  return {{"q0", quaternion(motion.q0)},
          {"q1", quaternion(motion.q1)},
          {"p0", output::exact(motion.p0)},
          {"p1", output::exact(motion.p1)}};
}

Json beginning_json(const Depth& depth) {
  return {{"status", name(depth.status())}, {"depth", output::length(depth.squared(), std::nullopt)}};
}

/// Returns one line, without its newline, in ASCII for any id.
std::string impact_json(const MovedCase& moved, const Impact& impact) {
  Json object = {{"schema", impact_schema}, {"id", moved.input.id}, {"status", name(impact.status)}};
  object["motion"] = {{"a", motion_json_of(moved.motions.a)}, {"b", motion_json_of(moved.motions.b)}};
  object["first_contact"] = impact.contact ? contact_json(*impact.contact) : Json();
  object["beginning"] = impact.beginning ? beginning_json(*impact.beginning) : Json();
  Json pieces = Json::array();
  for (const ImpactPiece& piece : impact.pieces) pieces.push_back(piece_json(piece));
  object["pieces"] = std::move(pieces);
  object["questions"] = impact.questions;
  return object.text();
}

Impact answered_impact(const MovedCase& moved, const ImpactRequest& request, Monitor& monitor) try {
  return moved.impact(request.options, monitor);
} catch (const std::invalid_argument& error) {
  throw InputError(moved.input.id, 0, error.what());
} catch (const ImpactTooLong& error) {
  throw InputError(moved.input.id, 0, error.what());
}

Replies impact_replies(const ImpactRequest& request) {
  Replies replies;
  replies.refuses_shapes = "impact takes polytopes";
  replies.refuses_unions = "impact takes polytopes";
  replies.refuses_plane = "impact takes bodies of space";
  replies.reads_text = true;  // Case has no motions
  replies.reply = [&request,
                   files = std::make_shared<FilePlaces>(request, request.certificate, "certificate", ".cert")](
                      const AskedCase& asked, Monitor& monitor, Workspace&) -> CaseReply {
    const std::unique_ptr<CertificateFile> proof = files->single();  // fails early for an unwritable path
    const MovedCase moved{asked, asked_motions(request, asked)};
    const Impact impact = answered_impact(moved, request, monitor);
    const std::string& id = moved.input.id;
    CaseReply reply{request.json         ? impact_json(moved, impact)
                    : is_stream(request) ? impact_line(id, impact, request.form)
                                         : impact_block(impact, request.form)};
    if (!files->wanted()) return reply;
    const std::string certificate = moved.certificate(impact, monitor);
    require_readable(id, certificate);
    if (proof) proof->write(certificate);
    else reply.keep = [files, id, certificate] { files->write_to_folder(id, certificate); };
    return reply;
  };
  if (request.json)
    replies.error_line = [](const CaseItem& item, const std::string& fault) {
      return output::error_object(impact_schema, item.id, item.line, fault);
    };
  return replies;
}

}  // namespace

ExitCode run_impact(const Given& given) {
  const ImpactRequest request(given);
  return reply_to_inputs(request, impact_replies(request));
}

}  // namespace fathom::cli
