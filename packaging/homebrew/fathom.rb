# SPDX-License-Identifier: GPL-3.0-or-later
# A formula for Homebrew on Linux. It is untried: nobody has built it. SOURCE and SHA256 stand for what a release has. On macOS fathom has
# never been built: it uses prctl, close_range and /proc.
class Fathom < Formula
  desc "Exact penetration depth of two convex bodies, with a proof"
  homepage "SOURCE"
  url "SOURCE/archive/v0.1.0.tar.gz"
  sha256 "SHA256"
  license all_of: ["GPL-3.0-or-later", "Apache-2.0", "CC0-1.0", "MIT"]

  depends_on "cgal" => :build
  depends_on "cli11" => :build
  depends_on "cmake" => :build
  depends_on "ninja" => :build
  depends_on "assimp"
  depends_on "fmt"
  depends_on "gmp"
  depends_on "libmd"
  depends_on :linux
  depends_on "mimalloc"
  depends_on "mpfr"
  depends_on "pugixml"
  depends_on "tbb"
  depends_on "zstd"

  def install
    system "cmake", "-G", "Ninja", "-S", ".", "-B", "build", "-DFATHOM_TESTS=OFF", "-DFATHOM_PYTHON=OFF", *std_cmake_args
    system "cmake", "--build", "build", "--target", "installed"
    system "cmake", "--install", "build"
  end

  test do
    system "#{bin}/fathom cases --family boxes_aligned --count 2 > cases.jsonl"
    system bin/"fathom", "depth", "cases.jsonl"
  end
end
