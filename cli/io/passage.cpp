// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/io/passage.hpp"

#include <algorithm>

#include "cli/io/packed.hpp"

namespace fathom::cli {
namespace {

/// What an error says behind file and line.
std::string message_of(const InputError& error) {
  const std::string sentence = error.what(), place = InputError(error.file(), error.line(), "").what();
  return sentence.substr(std::min(place.size(), sentence.size()));
}

std::string notes_text(const std::vector<StreamNote>& notes) {
  std::string all;
  for (const StreamNote& note : notes) {
    pack(all, std::to_string(static_cast<unsigned>(note.kind)));
    pack(all, note.text);
  }
  return all;
}

std::vector<StreamNote> notes_of(const std::string& text) {
  const std::vector<std::string> texts = unpacked(text);
  std::vector<StreamNote> notes;
  for (std::size_t i = 0; i + 1 < texts.size(); i += 2) notes.push_back({static_cast<NoteKind>(std::stoul(texts[i])), texts[i + 1]});
  return notes;
}

}  // namespace

void pack_answer(std::string& all, const Passage& passage) {
  const auto optional = [](const std::optional<std::string>& text) { return text ? "+" + *text : ""; };
  std::vector<std::string> texts = {passage.id, std::to_string(passage.code), passage.perhaps_inner ? "+" : "", optional(passage.hull_note),
                                    notes_text(passage.notes)};
  if (passage.fault) texts.insert(texts.end(), {passage.fault->file(), std::to_string(passage.fault->line()), message_of(*passage.fault)});
  else texts.push_back(passage.reply.text);
  pack(all, packed(texts));
}

void take_answer(const std::string& text, Passage& passage) {
  const std::vector<std::string> texts = unpacked(text);
  passage.id = texts.at(0);
  passage.code = static_cast<ExitCode>(std::stoi(texts.at(1)));
  passage.perhaps_inner = !texts.at(2).empty();
  if (!texts.at(3).empty()) passage.hull_note = texts[3].substr(1);
  passage.notes = notes_of(texts.at(4));
  if (texts.size() > 6) passage.fault = InputError(texts[5], std::stoull(texts.at(6)), texts.at(7));
  else passage.reply.text = texts.at(5);
  passage.answered = true;
}

}  // namespace fathom::cli
