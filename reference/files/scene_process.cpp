// SPDX-License-Identifier: GPL-3.0-or-later
// Assimp, on a file that may be hostile: in a forked process with limits on memory and time, which
// can open no file, and whose answer comes back through a pipe. A crash there is an error here.
//
// The library is loaded when the first such file is read, not linked: it would double the time that
// fathom takes to start, and everything but these files works without it.
#include <dlfcn.h>
#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <utility>

#include "fathom/files.hpp"
#include "kernels/messages.hpp"
#include "reference/files/scene_files.hpp"

#ifdef FATHOM_ASSIMP
#include <assimp/cfileio.h>
#include <assimp/cimport.h>
#include <assimp/config.h>
#include <assimp/scene.h>
#include <assimp/version.h>
#endif

namespace fathom::files {
namespace {

[[noreturn]] void refuse_scene(const CheckedScene& scene, const std::string& why) {
  throw InputError(scene.name, 0, "cannot be read as " + std::string(scene_word(scene.format)) + ": " + why);
}

}  // namespace

#ifdef FATHOM_ASSIMP
namespace {

// For a file of no size, and for each of its bytes, or MiB.
constexpr rlim_t least_seconds = 10, seconds_a_mebibyte = 1, least_memory = rlim_t{512} << 20, memory_a_byte = 64;
constexpr std::chrono::seconds most_waiting{300};
constexpr std::size_t most_of_answer = std::size_t{4} << 30;

// ---- the functions of the library ----

struct AssimpCalls {
  decltype(&aiImportFileExWithProperties) import = nullptr;
  decltype(&aiGetErrorString) error = nullptr;
  decltype(&aiCreatePropertyStore) options = nullptr;
  decltype(&aiSetImportPropertyInteger) set = nullptr;
  decltype(&aiGetVersionMajor) major = nullptr;
  decltype(&aiGetVersionMinor) minor = nullptr;
  bool all = false;

  AssimpCalls() {
    void* const library = ::dlopen("libassimp.so.5", RTLD_NOW | RTLD_LOCAL);
    if (!library) return;
    const auto find = [&](auto& call, const char* symbol) {
      call = reinterpret_cast<std::remove_reference_t<decltype(call)>>(::dlsym(library, symbol));
      return call != nullptr;
    };
    all = find(import, "aiImportFileExWithProperties") && find(error, "aiGetErrorString") &&
          find(options, "aiCreatePropertyStore") && find(set, "aiSetImportPropertyInteger") &&
          find(major, "aiGetVersionMajor") && find(minor, "aiGetVersionMinor");
  }
};

// ---- files of the scene, from memory ----

struct SceneBytes {
  std::string_view bytes;
  std::size_t at = 0;
};

SceneBytes& opened(aiFile* file) { return *reinterpret_cast<SceneBytes*>(file->UserData); }

std::size_t read_bytes(aiFile* file, char* to, std::size_t size, std::size_t count) {
  SceneBytes& from = opened(file);
  if (size == 0) return 0;
  const std::size_t whole = std::min(count, (from.bytes.size() - from.at) / size);
  std::memcpy(to, from.bytes.data() + from.at, whole * size);
  from.at += whole * size;
  return whole;
}

aiReturn seek_bytes(aiFile* file, std::size_t offset, aiOrigin origin) {
  SceneBytes& in = opened(file);
  const std::size_t from = origin == aiOrigin_SET ? 0 : origin == aiOrigin_CUR ? in.at : in.bytes.size();
  const std::size_t to = from + offset;  // wraps for an offset below zero
  if (to > in.bytes.size()) return aiReturn_FAILURE;
  in.at = to;
  return aiReturn_SUCCESS;
}

/// By which Assimp tells the format.
std::string name_of_bytes(const CheckedScene& scene) {
  if (scene.format == MeshFormat::gltf) return scene.bytes.starts_with("glTF") ? "scene.glb" : "scene.gltf";
  return scene.format == MeshFormat::collada ? "scene.dae" : "scene.3mf";
}

aiFile* open_bytes(aiFileIO* system, const char* path, const char* mode) {
  const auto& scene = *reinterpret_cast<const CheckedScene*>(system->UserData);
  if (std::strchr(mode, 'w') || std::strchr(mode, 'a')) return nullptr;
  std::string_view file(path);
  if (file.starts_with("./")) file.remove_prefix(2);
  const auto beside = scene.beside.find(std::string(file));
  const bool is_scene = file == name_of_bytes(scene);
  if (!is_scene && beside == scene.beside.end()) return nullptr;
  auto* const from = new SceneBytes{is_scene ? scene.bytes : std::string_view(beside->second)};
  return new aiFile{read_bytes,
                    [](aiFile*, const char*, std::size_t, std::size_t) -> std::size_t { return 0; },
                    [](aiFile* f) { return opened(f).at; },
                    [](aiFile* f) { return opened(f).bytes.size(); },
                    seek_bytes,
                    [](aiFile*) {},
                    reinterpret_cast<aiUserData>(from)};
}

void close_bytes(aiFileIO*, aiFile* file) {
  delete &opened(file);
  delete file;
}

// ---- the answer, as bytes: both processes are the same program ----

constexpr char good = 'S', bad = 'E', whole = 'Z';

struct AnswerWriter {
  std::string bytes;
  void number(std::uint64_t value) { bytes.append(reinterpret_cast<const char*>(&value), sizeof value); }
  void text(std::string_view value) {
    number(value.size());
    bytes.append(value);
  }
  template <class Item>
  void items(const std::vector<Item>& all) {
    number(all.size());
    bytes.append(reinterpret_cast<const char*>(all.data()), all.size() * sizeof(Item));
  }
};

/// Reads what AnswerWriter wrote; `sound` becomes false where the bytes are too few.
struct AnswerReader {
  std::string_view bytes;
  bool sound = true;
  std::string_view take(std::uint64_t count, std::size_t size) {
    sound = sound && count <= bytes.size() / size;
    const std::string_view taken = bytes.substr(0, sound ? count * size : 0);
    bytes.remove_prefix(taken.size());
    return taken;
  }
  std::uint64_t number() {
    std::uint64_t value = 0;
    const std::string_view taken = take(1, sizeof value);
    std::memcpy(&value, taken.data(), taken.size());
    return value;
  }
  std::string text() { return std::string(take(number(), 1)); }
  template <class Item>
  std::vector<Item> items() {
    const std::string_view taken = take(number(), sizeof(Item));
    std::vector<Item> all(taken.size() / sizeof(Item));
    if (!all.empty()) std::memcpy(all.data(), taken.data(), taken.size());
    return all;
  }
};

std::string_view text_of(const aiString& text) { return {text.data, text.length}; }

void write_mesh(const aiMesh& mesh, AnswerWriter& to) {
  to.text(text_of(mesh.mName));
  std::vector<std::array<float, 3>> points(mesh.mNumVertices);
  for (unsigned i = 0; i < mesh.mNumVertices; ++i)
    points[i] = {mesh.mVertices[i].x, mesh.mVertices[i].y, mesh.mVertices[i].z};
  to.items(points);
  MeshFaces faces;
  for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
    const aiFace& face = mesh.mFaces[i];
    faces.corners.insert(faces.corners.end(), face.mIndices, face.mIndices + face.mNumIndices);
    faces.ends.push_back(static_cast<std::uint32_t>(faces.corners.size()));
  }
  to.items(faces.corners);
  to.items(faces.ends);
}

void write_nodes(const aiNode& node, std::vector<std::array<float, 16>>& above, AnswerWriter& to) {
  const aiMatrix4x4& m = node.mTransformation;
  above.push_back({m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4, m.c1, m.c2, m.c3, m.c4, m.d1, m.d2, m.d3, m.d4});
  if (node.mNumMeshes > 0) {
    to.number(1);
    to.text(text_of(node.mName));
    to.items(above);
    to.items(std::vector<std::uint32_t>(node.mMeshes, node.mMeshes + node.mNumMeshes));
  }
  for (unsigned i = 0; i < node.mNumChildren; ++i) write_nodes(*node.mChildren[i], above, to);
  above.pop_back();
}

std::string answer_of(const AssimpCalls& assimp, const CheckedScene& scene) {
  aiFileIO files{open_bytes, close_bytes,
                 const_cast<aiUserData>(reinterpret_cast<const char*>(&scene))};  // it is only read
  aiPropertyStore* const options = assimp.options();
  assimp.set(options, AI_CONFIG_IMPORT_COLLADA_USE_COLLADA_NAMES, 1);
  const aiScene* const found = assimp.import(name_of_bytes(scene).c_str(), 0, &files, options);
  AnswerWriter answer;
  if (!found || !found->mRootNode) {
    answer.bytes = bad;
    answer.text(assimp.error());
  } else {
    answer.bytes = good;
    answer.text(std::to_string(assimp.major()) + "." + std::to_string(assimp.minor()));
    answer.number(found->mNumMeshes);
    for (unsigned i = 0; i < found->mNumMeshes; ++i) write_mesh(*found->mMeshes[i], answer);
    std::vector<std::array<float, 16>> above;
    write_nodes(*found->mRootNode, above, answer);
    answer.number(0);
  }
  return answer.bytes + whole;
}

// ---- the process ----

void limit(int resource, rlim_t most) {
  const rlimit both{most, most};
  ::setrlimit(static_cast<__rlimit_resource>(resource), &both);
}

/// What is mapped now, terabytes under AddressSanitizer: the limit counts that too.
rlim_t memory_in_use() {
  unsigned long pages = 0;
  if (std::FILE* const file = std::fopen("/proc/self/statm", "re")) {
    if (std::fscanf(file, "%lu", &pages) != 1) pages = 0;
    std::fclose(file);
  }
  return rlim_t{pages} * static_cast<rlim_t>(::sysconf(_SC_PAGESIZE));
}

void confine(std::size_t bytes) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGTRAP, SIGINT, SIGTERM, SIGPIPE})
    std::signal(signal, SIG_DFL);
  const int null = ::open("/dev/null", O_RDWR | O_CLOEXEC);  // for what libc says of a crash
  for (const int standard : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) ::dup2(null, standard);
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_CPU, least_seconds + seconds_a_mebibyte * (bytes >> 20));
  limit(RLIMIT_AS, memory_in_use() + least_memory + memory_a_byte * bytes);
  limit(RLIMIT_NOFILE, 0);  // no file can be opened any more
}

[[noreturn]] void run_and_exit(const AssimpCalls& assimp, const CheckedScene& scene, int pipe) {
  std::size_t bytes = scene.bytes.size();
  for (const auto& [uri, buffer] : scene.beside) bytes += buffer.size();
  confine(bytes);
  try {
    const std::string answer = answer_of(assimp, scene);
    for (std::string_view rest = answer; !rest.empty();) {
      const ssize_t written = ::write(pipe, rest.data(), rest.size());
      if (written <= 0) ::_exit(1);
      rest.remove_prefix(static_cast<std::size_t>(written));
    }
  } catch (...) {
    ::_exit(2);
  }
  ::_exit(0);
}

/// Reads to the end of the pipe, or until it takes too long.
std::string read_answer(int pipe) {
  const auto end = std::chrono::steady_clock::now() + most_waiting;
  std::string answer;
  std::vector<char> block(std::size_t{1} << 18);
  while (answer.size() <= most_of_answer) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - std::chrono::steady_clock::now());
    if (left.count() <= 0) break;
    pollfd waits{pipe, POLLIN, 0};
    const int ready = ::poll(&waits, 1, static_cast<int>(left.count()));
    if (ready < 0 && errno == EINTR) continue;
    const ssize_t got = ready > 0 ? ::read(pipe, block.data(), block.size()) : 0;
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) break;
    answer.append(block.data(), static_cast<std::size_t>(got));
  }
  return answer;
}

/// Runs Assimp; returns its answer, which is cut short if it failed, and why in `ended`.
std::string answer_of_process(const AssimpCalls& assimp, const CheckedScene& scene, std::string& ended) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) refuse_scene(scene, "no pipe for the process that reads it");
  const pid_t child = ::fork();
  if (child == 0) run_and_exit(assimp, scene, ends[1]);
  ::close(ends[1]);
  std::string answer = child > 0 ? read_answer(ends[0]) : "";
  ::close(ends[0]);
  if (child < 0) refuse_scene(scene, "no process that could read it");
  if (!answer.ends_with(whole)) ::kill(child, SIGKILL);  // it took too long, if it has not ended
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  ended = WIFSIGNALED(status) ? "signal " + std::to_string(WTERMSIG(status)) : "no answer";
  return answer;
}

/// What is said where Assimp refuses a file; its own messages are about its insides.
std::string expected_instead(const std::string& message) {
  struct Said {
    const char *assimp, *here;
  };
  constexpr Said all[] = {
      {"Invalid data index", "the corners of its faces name values that its sources do not have"},
      {"Expected more values", "a <float_array> has fewer numbers than its count says"},
      {"malformed XML", "expected well-formed XML"},
      {"recursive reference", "a part of it contains itself"},
      {"no meshes", "expected at least one mesh, found none"},
      {"empty", "expected at least one mesh, found none"},
  };
  unsigned long index = 0, below = 0;
  if (std::sscanf(message.c_str(), "Invalid data index (%lu/%lu)", &index, &below) == 2)
    return "expected an index below " + std::to_string(below) + " in the <p> of a geometry, found " +
           std::to_string(index);
  for (const Said& said : all)
    if (message.find(said.assimp) != std::string::npos) return said.here;
  return "expected a scene with meshes that Assimp reads";
}

}  // namespace

AssimpScene imported(const CheckedScene& scene) {
  static const AssimpCalls assimp;
  if (!assimp.all) refuse_scene(scene, "Assimp, which reads it, is not installed here (Debian: libassimp5)");
  std::string ended;
  const std::string answer = answer_of_process(assimp, scene, ended);
  if (answer.size() < 2 || answer.back() != whole)
    refuse_scene(scene, "Assimp, in a process of its own, ended without an answer on it (" + ended + ")");
  AnswerReader reader{std::string_view(answer).substr(1, answer.size() - 2)};
  if (answer.front() == bad) refuse_scene(scene, expected_instead(reader.text()));
  AssimpScene result;
  result.version = reader.text();
  for (std::uint64_t left = reader.number(); left > 0 && reader.sound; --left) {
    AssimpScene::Mesh& mesh = result.meshes.emplace_back();
    mesh.name = reader.text();
    mesh.points = reader.items<std::array<float, 3>>();
    mesh.faces = {reader.items<std::uint32_t>(), reader.items<std::uint32_t>()};
    const std::vector<std::uint32_t>& ends = mesh.faces.ends;
    reader.sound =
        reader.sound && std::ranges::is_sorted(ends) && (ends.empty() ? 0 : ends.back()) == mesh.faces.corners.size();
  }
  while (reader.sound && reader.number() == 1) {
    AssimpScene::Node& node = result.nodes.emplace_back();
    node.name = reader.text();
    node.matrices = reader.items<std::array<float, 16>>();
    node.meshes = reader.items<std::uint32_t>();
    reader.sound = reader.sound && std::ranges::all_of(node.meshes, [&](auto i) { return i < result.meshes.size(); });
  }
  if (!reader.sound) refuse_scene(scene, "the answer of Assimp does not agree with itself");
  return result;
}

#else

AssimpScene imported(const CheckedScene& scene) {
  refuse_scene(scene, "this fathom was built without Assimp, which reads it (Debian: libassimp-dev)");
}

#endif

}  // namespace fathom::files
