// SPDX-License-Identifier: GPL-3.0-or-later
// The files that a command line names: nothing that is written may be something that is read, or written otherwise. Each option says here
// what its value is; wrong_files decides, before anything is opened.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace fathom::cli {

/// What the value of an option names. Positional words are read.
enum class FileUse {
  read,
  read_list,     ///< a file that write_list may bring up to date
  journal,       ///< a file that grows: its writer never replaces it
  written,       ///< a file
  written_list,  ///< a file that may be the one that read_list names
  placed,        ///< a file; of a stream, a folder for a file of each case, which may be that of another option
  folder,        ///< a folder for files of names that the command chooses
};

/// Notes what the option's value names. Returns the option.
CLI::Option* names_file(CLI::Option* option, FileUse use);

/// Says which output of the command would destroy an input or another output, standard streams included; or a file that is named like a
/// mesh or like cases, as where the name of an output was forgotten; or "". Files are the same by what the file system says, however they
/// are named; devices and pipes are passed over. `stream`: the command answers a stream of cases.
std::string wrong_files(const CLI::App& asked, bool stream);

}  // namespace fathom::cli
