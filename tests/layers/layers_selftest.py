#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Shows that layers.py lets a clean tree pass and finds each kind of breach in a small bad one."""
import contextlib
import io
import pathlib
import sys
import tempfile
import unittest
import unittest.mock

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).parent))
import layers  # noqa: E402

SPDX = "// SPDX-License-Identifier: GPL-3.0-or-later\n"
CLEAN = {
    "include/fathom/point.hpp": SPDX + "#include <gmpxx.h>\n",
    "include/fathom/depth.hpp": SPDX + '#include <vector>\n#include "fathom/point.hpp"\n',
    "include/fathom/cgal.hpp": SPDX + "#include <CGAL/Exact_rational.h>\n",
    "kernels/sign.hpp": SPDX + "#include <gmpxx.h>\n#include <string_view>\n",
    "kernels/sign.cpp": SPDX + '#include "kernels/sign.hpp"\n#include <CGAL/Interval_nt.h>\n',
    "kernels/round.cpp": SPDX + "#include <cfenv>\n#include <mpfr.h>\n",
    "reference/polytope/hull.hpp": SPDX + '#include "kernels/sign.hpp"\n',
    "reference/polytope/mesh_cgal.hpp": SPDX + "#include <CGAL/Surface_mesh.h>\n",
    "reference/depth/depth.cpp": SPDX + '#include "reference/depth/depth.hpp"\n#include "reference/polytope/hull.hpp"\n'
                                        "#include <fmt/format.h>\n",
    "reference/depth/depth.hpp": SPDX + "#include <vector>\n",
    "verify/check/checker.cpp": "// SPDX-License-Identifier: Apache-2.0\n#include <gmpxx.h>\n",
    "cli/main.cpp": SPDX + '#include "reference/depth/depth.hpp"\n#include <CLI/CLI.hpp>\n',
    "tests/depth/depth_test.cpp": SPDX + '#include "cli/main.cpp"\n',
    "cmake/cgal_files.txt": "# comment\nkernels/sign.cpp\nreference/polytope/mesh_cgal.hpp\ninclude/fathom/cgal.hpp\n",
    "cmake/install.cmake": "# SPDX-License-Identifier: GPL-3.0-or-later\ninstall(TARGETS fathom_headers EXPORT x FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})\n"
    "install(TARGETS fathom_kernels fathom EXPORT x)\ninstall(FILES LICENSE verify/check/FORMAT.md DESTINATION ${CMAKE_INSTALL_DOCDIR})\n",
    "fathom": "#!/usr/bin/env bash\n# SPDX-License-Identifier: GPL-3.0-or-later\n",
}


def breaches(changes=None):
    """The (file, law) pairs found in the clean tree after the changes."""
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        for name, text in {**CLEAN, **(changes or {})}.items():
            (root / name).parent.mkdir(parents=True, exist_ok=True)
            (root / name).write_text(text)
        return [(name, law) for name, law, _ in layers.breaches(root)]


class Layers(unittest.TestCase):
    def expect(self, name, text, *laws):
        self.assertEqual(breaches({name: text}), [(name, law) for law in laws])

    def test_clean_tree_passes(self):
        self.assertEqual(breaches(), [])

    def test_room_to_the_right(self):
        self.expect("kernels/bad.cpp", SPDX + '#include "reference/polytope/hull.hpp"\n', "order")
        self.expect("reference/polytope/bad.cpp", SPDX + '  #  include "reference/depth/depth.hpp"\n', "order")
        self.expect("reference/depth/bad.cpp", SPDX + '#include "cli/main.cpp"\n', "order")
        self.expect("cli/bad.cpp", SPDX + '#include "tests/depth/depth_test.cpp"\n', "order")

    def test_neighbours_do_not_know_each_other(self):
        changes = {
            "reference/canonical/subsets.hpp": SPDX,
            "reference/vertex_facet/bad.cpp": SPDX + '#include "reference/canonical/subsets.hpp"\n',
        }
        self.assertEqual(breaches(changes), [("reference/vertex_facet/bad.cpp", "order")])

    def test_path_from_the_root(self):
        self.expect("reference/depth/bad.cpp", SPDX + '#include "depth.hpp"\n', "order")
        self.expect("reference/depth/bad.cpp", SPDX + '#include "reference/polytope/missing.hpp"\n', "order")

    def test_unknown_room(self):
        self.expect("reference/attic/bad.cpp", SPDX, "order")
        self.expect("attic/bad.cpp", SPDX, "order")

    def test_checker_is_alone(self):
        self.expect("verify/check/bad.cpp", "// SPDX-License-Identifier: Apache-2.0\n" + '#include "kernels/sign.hpp"\n', "order")
        self.expect("verify/check/bad.cpp", "// SPDX-License-Identifier: Apache-2.0\n" + '#include "../../kernels/sign.hpp"\n', "order")
        self.expect("verify/check/bad.cpp", "// SPDX-License-Identifier: Apache-2.0\n" + '#include "verify/check/checker.cpp"\n', "order")
        self.expect("verify/check/good.cpp", "// SPDX-License-Identifier: Apache-2.0\n" + '#include "checker.cpp"\n')
        self.expect("verify/families/bad.cpp", SPDX + '#include "verify/check/checker.cpp"\n', "order")

    def test_doors_are_light(self):
        self.expect("reference/depth/bad.hpp", SPDX + "#include <nlohmann/json.hpp>\n", "doors")
        self.expect("reference/depth/bad.hpp", SPDX + "#include <CGAL/Surface_mesh.h>\n", "cgal")

    def test_cgal_only_where_listed(self):
        self.expect("reference/depth/bad.cpp", SPDX + "#include <CGAL/Surface_mesh.h>\n", "cgal")
        self.expect("tests/depth/bad_test.cpp", SPDX + "#include <CGAL/Surface_mesh.h>\n", "cgal")
        self.expect("cli/bad.cpp", SPDX + "#include <boost/multiprecision/gmp.hpp>\n", "cgal")
        self.expect("tests/depth/bad_test.cpp", SPDX + '#include "reference/polytope/mesh_cgal.hpp"\n', "cgal")

    def test_list_holds_nothing_else(self):
        text = CLEAN["cmake/cgal_files.txt"]
        self.expect("cmake/cgal_files.txt", text + "cli/main.cpp\n", "cgal")
        self.expect("cmake/cgal_files.txt", text + "cli/missing.cpp\n", "cgal")

    def test_a_header_is_compiled_alone_by_its_source(self):
        name, header = "reference/polytope/hull.cpp", '#include "reference/polytope/hull.hpp"\n'
        self.expect(name, SPDX + header + "#include <vector>\n")
        self.expect(name, SPDX + "#include <vector>\n" + header, "first")
        self.expect(name, SPDX, "first")
        self.expect("reference/polytope/part.cpp", SPDX + "#include <vector>\n" + header)

    def test_rounding_stays_in_kernels(self):
        self.expect("reference/depth/bad.cpp", SPDX + "#include <cfenv>\n", "rounding")
        self.expect("cli/bad.cpp", SPDX + "void f() { std::fesetround(0); }\n", "rounding")

    def test_licence_line(self):
        self.expect("cli/bad.cpp", "int x;\n", "licence")
        self.expect("verify/check/bad.cpp", SPDX, "licence")
        self.expect("cmake/bad.cmake", "set(x 1)\n", "licence")
        self.expect("fathom", "#!/usr/bin/env bash\nexit\n", "licence")

    def test_length(self):
        self.expect("cli/long.cpp", SPDX + "\n" * 599)
        self.expect("cli/long.cpp", SPDX + "\n" * 600, "length")

    def test_length_of_functions(self):
        def function(indent, lines, inside="  f();"):
            return "\n".join(indent + line for line in ["void g(int i,", "       int j) {", *[inside] * (lines - 3), "}"]) + "\n"
        for before, indent, after in (("", "", ""), ("struct X {\n", "  ", "};\n"), ("struct X {\n  struct Y {\n", "    ", "  };\n};\n")):
            self.expect("cli/long.cpp", SPDX + before + function(indent, 60) + after)
            self.expect("cli/long.cpp", SPDX + before + function(indent, 61) + after, "length")
            self.expect("cli/long.cpp", SPDX + before + 3 * function(indent, 30) + after)
            self.expect("cli/long.cpp", SPDX + before + function(indent, 61, "      {1},") + after)  # a table

    def test_headers_with_one_reader(self):
        readers = {"a/x.hpp": {"a/y.cpp"}, "a/z.hpp": {"a/y.cpp", "b/y.cpp"}}
        with unittest.mock.patch.object(layers, "ONE_READER", 0):
            self.assertEqual([name for name, _, _ in layers.reader_breaches(readers)], ["a/x.hpp"])
            self.assertEqual(breaches(), [("kernels/sign.hpp", "readers")])
        self.assertEqual(list(layers.reader_breaches(readers)), [])

    def test_wide_lines(self):
        words = "word " * 30
        for line in (f"// {words}", f"  /// {words}", f"/** {words}*/", f" * {words}"):
            self.expect("cli/wide.cpp", SPDX + line + "\n", "width")
        for line in (f"//> {words}", f"// https://{words}", f'const char* text = "{words}";', "// " + "x" * 97, f"// {words}"[:100]):
            self.expect("cli/wide.cpp", SPDX + line + "\n")
        spdx = "# SPDX-License-Identifier: GPL-3.0-or-later\n"
        for line in (f"# {words}", f'"""{words}"""', f'"""Words.\n{words}"""', f"f({words.replace(' ', ', ')})"):
            self.expect("cli/wide.py", spdx + line + "\n", "width")
        for line in (f"text = '{words}'", f"# https://{words}", "# " + "x" * 138):
            self.expect("cli/wide.py", spdx + line + "\n")

    def test_a_type_has_a_name_of_its_own(self):
        first = SPDX + "namespace fathom {\n\n%s\n}  // namespace fathom\n"
        for text in ("struct Place {", "enum class Place : char {", "template <class T> class Place final : Base<T> {",
                     "class [[nodiscard]] Place {", "struct alignas(16) Place {", "using Place = int;", "using Place =\n    int;",
                     "struct Place\n    : Base {"):
            changes = {"reference/depth/one.hpp": first % "struct Place {\n  int x;\n};\n", "reference/depth/two.cpp": first %
                       (text + ("\n};\n" if "{" in text else "\n"))}
            self.assertEqual(breaches(changes), [("reference/depth/two.cpp", "names")], text)

    def test_whatever_the_namespace(self):
        place = SPDX + "namespace %s {\n\nstruct Place {\n};\n\n}  // namespace %s\n"
        changes = {"kernels/one.hpp": place % ("fathom", "fathom"), "cli/two.cpp": place % ("fathom::cli", "fathom::cli")}
        self.assertEqual(breaches(changes), [("kernels/one.hpp", "names")])

    def test_a_room_has_a_namespace_of_its_own(self):
        space = SPDX + "namespace fathom::%s {\n}  // namespace fathom::%s\n"
        for name, own in (("kernels/number/a.hpp", "kernels"), ("reference/depth/a.cpp", "depth"), ("verify/judge/a.cpp", "judging"),
                          ("cli/io/a.hpp", "cli")):
            self.expect(name, space % (own, own))
            self.expect(name, SPDX + "namespace fathom {\n}  // namespace fathom\n")
            self.expect(name, space % ("polytope", "polytope"), "namespace")
        self.expect("kernels/number/a.hpp", space % ("kernels::inner", "kernels::inner"))
        self.expect("include/fathom/bad.hpp", space % ("kernels", "kernels"), "namespace")
        self.expect("tests/depth/a.hpp", space % ("polytope", "polytope"))

    def test_types_that_may_share_a_name(self):
        inside = SPDX + "namespace fathom {\n%s}  // namespace fathom\n"
        one = {"reference/depth/one.hpp": inside % "struct Place {\n};\n"}
        for text in ("namespace {\n\nstruct Place {\n};\n\n}  // namespace\n", "struct Place;\n",
                     "struct Other {\n  struct Place {\n  };\n};\n"):
            self.assertEqual(breaches({**one, "reference/depth/two.cpp": inside % text}), [], text)
        place = "namespace other {\nstruct Place {\n};\n}  // namespace other\n"
        self.assertEqual(breaches({**one, "tests/depth/place.hpp": SPDX + place}), [])
        self.assertEqual(breaches({**one, "verify/check/place.hpp": "// SPDX-License-Identifier: Apache-2.0\n" + place}), [])

    def test_what_users_include(self):
        self.expect("include/fathom/bad.hpp", SPDX + '#include "kernels/sign.hpp"\n', "order")
        self.expect("include/fathom/bad.hpp", SPDX + "#include <fmt/format.h>\n", "doors")
        self.expect("include/fathom/bad.hpp", SPDX + "#include <CGAL/Surface_mesh.h>\n", "cgal")
        self.expect("include/fathom/cgal.hpp", SPDX + '#include <CGAL/Exact_rational.h>\n#include "kernels/sign.hpp"\n', "order")

    def test_only_chosen_headers_are_installed(self):
        for call in ("TARGETS fathom_kernels EXPORT x FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}",
                     "TARGETS fathom_headers fathom_judge EXPORT x\n  FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}",
                     "TARGETS fathom_headers PUBLIC_HEADER DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}",
                     "FILES kernels/sign.hpp DESTINATION ${CMAKE_INSTALL_DOCDIR}", "FILES verify/judge/judge.h DESTINATION x",
                     "DIRECTORY kernels DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}", "DIRECTORY kernels DESTINATION include/fathom",
                     "DIRECTORY . DESTINATION x FILES_MATCHING PATTERN *.hpp"):
            self.expect("cmake/bad.cmake", f"# SPDX-License-Identifier: GPL-3.0-or-later\nif(X)\n  install({call})\nendif()\n", "installed")

    def test_each_public_function_has_an_example(self):
        header = SPDX + """#include <vector>
namespace fathom {
/// Not decoy(this).
struct Box {
  explicit Box(int x) : base(x) {}
  ~Box();
  Box& operator=(const Box&);
  [[nodiscard]] int volume() const { return twice(x_); }
};
enum class Kind { one, two };
inline constexpr int limit = compute(3);
template <class T>
requires(Solid<T>) Box largest(const std::vector<T>& boxes, int from = first(0), const Kind& kind = {});
}  // namespace fathom
"""
        program = SPDX + '#include <fathom/box.hpp>\nint main() { return fathom::largest<Box>(boxes).volume(); }\n'
        name = "include/fathom/box.hpp"
        self.assertEqual(breaches({name: header, "examples/box.cpp": program}), [])
        self.assertEqual(breaches({name: header, "examples/box.cpp": program.replace("volume", "depth")}), [(name, "examples")])
        self.assertEqual(breaches({name: header, "examples/box.cpp": program.replace("largest", "least")}), [(name, "examples")])
        self.assertEqual(breaches({name: header, "examples/box.cpp": program.replace("fathom/box.hpp", "vector")}), [(name, "examples")])
        self.assertEqual(breaches({name: header, "examples/box.cpp": program.replace("int main", "// int main")}), [(name, "examples")] * 2)
        c = SPDX + 'extern "C" {\ntypedef int fathom_ask(void* who);\nint fathom_volume(int x);\n}\n'
        self.assertEqual(breaches({"include/fathom/box.h": c}), [("include/fathom/box.h", "examples")] * 2)
        check = "// SPDX-License-Identifier: Apache-2.0\nnamespace fathom_check {\nbool verify(int x);\n}  // namespace fathom_check\n"
        self.assertEqual(breaches({"verify/check/check.hpp": check}), [("verify/check/check.hpp", "examples")] * 2)
        self.assertEqual(breaches({"include/fathom/box.h": c, "examples/box.c": "#include <fathom/box.h>\nint x = fathom_volume(3);\n"}),
                         [])

    def test_exit_code(self):
        with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stdout(io.StringIO()):
            sys.argv = ["layers.py", folder]
            self.assertEqual(layers.main(), 1)  # an empty tree proves nothing
            (pathlib.Path(folder) / "kernels").mkdir()
            (pathlib.Path(folder) / "kernels/a.cpp").write_text(SPDX)
            self.assertEqual(layers.main(), 0)
            (pathlib.Path(folder) / "kernels/a.cpp").write_text("")
            self.assertEqual(layers.main(), 1)


if __name__ == "__main__":
    unittest.main()
