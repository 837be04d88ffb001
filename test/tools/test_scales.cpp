// SPDX-License-Identifier: BSD-3-Clause
// Models of any size: they work, or are refused with a sentence that says why.
#include <cmath>
#include <fstream>
#include <sstream>

#include "program.hpp"

namespace multimesh::tools::test {
namespace {

/// A bumpy sphere-like surface of 72 triangles with a texture, in 6 x 6 quads around and up.
std::string model(double scale, double offset) {
  std::ostringstream out;
  out.precision(17);
  constexpr int n = 6;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) {
      const double u = double(i) / n, v = double(j) / n;
      out << "v " << offset + scale * u << ' ' << offset + scale * v << ' '
          << offset + scale * 0.2 * std::sin(3 * u) * std::cos(2 * v) << "\nvt " << u << ' ' << v << '\n';
    }
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const int a = i * (n + 1) + j + 1, b = a + n + 1;
      out << "f " << a << '/' << a << ' ' << b << '/' << b << ' ' << b + 1 << '/' << b + 1 << "\nf " << a
          << '/' << a << ' ' << b + 1 << '/' << b + 1 << ' ' << a + 1 << '/' << a + 1 << '\n';
    }
  return out.str();
}

class Scales : public ProgramTest {
 protected:
  /// Done, or refused with a sentence about the size; never ended by a signal. \return whether it was done
  bool done(const Arguments& arguments) const {
    const Ended e = run(arguments);
    EXPECT_EQ(e.signal, 0) << ::testing::PrintToString(arguments);
    EXPECT_TRUE(e.status == 0 || e.status == 1) << e.err;
    EXPECT_FALSE(contains(e.err, "internal error")) << e.err;
    const bool explained = contains(e.err, arguments[1]) && contains(e.err, "scale the model");
    EXPECT_TRUE(e.status == 0 || explained) << e.err;
    return e.status == 0;
  }
};

TEST_F(Scales, WorkOrAreRefusedWithTheReason) {
  for (const double scale :
       {1e-300, 1e-160, 1e-100, 1e-39, 1e-20, 1e-6, 1.0, 1e6, 1e20, 1e39, 1e100, 1e160, 1e300}) {
    SCOPED_TRACE(scale);
    file("in.obj", model(scale, 0));
    const bool expected = scale > 1e-40 && scale < 1e40;
    EXPECT_EQ(
        done({"decimate", "in.obj", "-o", "out.obj", "--ratio", "0.5", "--measure", "--report", "r.json"}),
        expected);
    EXPECT_EQ(done({"remesh", "in.obj", "-o", "even.obj", "--relative-length", "0.2"}), expected);
    EXPECT_EQ(done({"compare", "in.obj", "in.obj"}), expected);
    EXPECT_EQ(done({"info", "in.obj"}), expected);
    EXPECT_EQ(done({"validate", "in.obj"}), expected);
    EXPECT_EQ(exists("out.obj"), expected);
    fs::remove(directory / "out.obj");
  }
}

// Relative figures do not depend on the unit.
TEST_F(Scales, ChangeNoFigure) {
  Json first;
  for (const double scale : {1.0, 0x1p-120, 0x1p120}) {
    file("in.obj", model(scale, 0));
    ASSERT_TRUE(
        done({"decimate", "in.obj", "-o", "out.obj", "--ratio", "0.5", "--measure", "--report", "r.json"}));
    const Json measured = json("r.json")["measured"];
    if (first.is_null()) first = measured;
    EXPECT_NEAR(measured["distance"]["rms"].get<double>(), first["distance"]["rms"].get<double>(), 1e-9);
    EXPECT_NEAR(measured["texture"]["deviation"]["rms"].get<double>(),
                first["texture"]["deviation"]["rms"].get<double>(), 1e-9);
  }
}

TEST_F(Scales, FarFromTheOriginNothingCrashes) {
  for (const double offset : {1e6, 1e12, 1e15, 1e30, -1e39}) {
    SCOPED_TRACE(offset);
    file("in.obj", model(1, offset));
    for (const std::string command : {"info", "compare"}) {
      Arguments arguments = {command, "in.obj"};
      if (command == "compare") arguments.emplace_back("in.obj");
      EXPECT_EQ(run(arguments).signal, 0);
    }
    const Ended e = decimate("in.obj", "out.obj", {"--ratio", "0.5", "--measure"});
    EXPECT_EQ(e.signal, 0);
    EXPECT_FALSE(contains(e.err, "internal error")) << e.err;
  }
}

TEST_F(Scales, OfTextureCoordinates) {
  for (const std::string number : {"1e300", "1e160", "-1e41"}) {
    file("in.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 " + number + "\nf 1/1 2/2 3/3\n");
    const Ended e = decimate("in.obj", "out.obj", {"--ratio", "0.5", "--measure"});
    EXPECT_EQ(e.status, 1);
    EXPECT_TRUE(contains(e.err, "texture coordinate")) << e.err;
  }
}

TEST_F(Scales, OfTetrahedra) {
  for (const std::string number : {"1e-160", "1e160", "1"}) {
    file("in.vtk",
         "# vtk DataFile Version 2.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 double\n0 0 0 " + number +
             " 0 0 0 " + number + " 0 0 0 " + number + "\nCELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\n");
    EXPECT_EQ(done({"info", "in.vtk"}), number == "1");
    EXPECT_EQ(done({"validate", "in.vtk"}), number == "1");
  }
}

}  // namespace
}  // namespace multimesh::tools::test
