#include "08-post-processing/given/cube_texts.hpp"

namespace atelier {

namespace {

/// Lines of the colour black.
std::string black(int lines) {
  std::string text;
  for (int i = 0; i < lines; ++i) text += "0 0 0\n";
  return text;
}

}  // namespace

const std::vector<CubeText>& texts_to_read() {
  static const std::vector<CubeText> texts = {
      /* 0 */ {"LUT_3D_SIZE 2\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1\n1 0 1\n0 1 1\n1 1 1\n", ""},
      /* 1 */ {"LUT_3D_SIZE 2\n0.125 0.25 0.5\n1.5 0 0.25\n" + black(5) + "0.75 -0.5 1.5\n", ""},
      /* 2 */ {"TITLE \"warm\"\nLUT_3D_SIZE 2\n0.125 0.25 0.5\n1.5 0 0.25\n" + black(5) + "0.75 -0.5 1.5", "warm"},
      /* 3 */
      {"DOMAIN_MAX 2 4 8\nTITLE \"a  late  look\"\nDOMAIN_MIN -1 -0.5 0.25\nLUT_3D_SIZE 2\n0.125 0.25 0.5\n1.5 0 "
       "0.25\n" +
           black(5) + "0.75 -0.5 1.5\n",
       "a  late  look"},
      /* 4 */ {"TITLE \"LUT_3D_SIZE 5\"\nLUT_3D_SIZE 2\nDOMAIN_MIN 0.5 0 -2\n" + black(8), "LUT_3D_SIZE 5"},
      /* 5 */ {"TITLE \"no #3\"\nLUT_3D_SIZE 2\nDOMAIN_MAX 1.5 0.25 1e3\n" + black(8), "no #3"},
      /* 6 */ {"LUT_3D_SIZE 2\n0.1 1e-3 -2.5E1\n0.7 0.01 1\n" + black(5) + "0.33333334 123456.7 0\n", ""},
      /* 7 */ {"LUT_3D_SIZE 3\n1 2 3\n3 2 1\n" + black(24) + "4 5 6\n", ""},
      /* 8 */
      {"# a look\n\n TITLE\t\"x y\"  \n\n#LUT_3D_SIZE 9\n\tLUT_3D_SIZE \t 2\t\n# colours:\n  0.25  0.5\t0.75 \n\n \t "
       "\n9 8 7\n0 0 0\n0 0 0\n#\n" +
           black(3) + "\t4 5 6\t\n# the end\n\n",
       "x y"},
      /* 9 */ {"DOMAIN_MAX 0 0 0\nDOMAIN_MIN -1 -1 -1\nLUT_3D_SIZE 2\n0 0 0\n1 0 0\n" + black(5) + "1 1 1\n", ""},
      /* 10 */
      {"DOMAIN_MIN 2 2 2\nTITLE \"\"\nDOMAIN_MAX 3 3 3\nLUT_3D_SIZE 2\n0 0 0\n1 0 0\n" + black(5) + "1 1 1\n", ""},
  };
  return texts;
}

const std::vector<std::string>& texts_to_judge() {
  static const std::vector<std::string> texts = {
      // These are tables.
      /* 0 */ "LUT_3D_SIZE 2\n" + black(8),
      /* 1 */ "LUT_3D_SIZE 2\n" + black(7) + "0 0 0",
      /* 2 */ "LUT_3D_SIZE 2\r\n0 0 0\r\n0 0 0\r\n0 0 0\r\n0 0 0\r\n0 0 0\r\n0 0 0\r\n0 0 0\r\n0 0 0\r\n",
      /* 3 */
      "TITLE \"a b\"\r\nDOMAIN_MIN 0 0 0\r\nDOMAIN_MAX 1 1 1\r\n\r\n# colours\r\nLUT_3D_SIZE 2\r\n0 0 0\r\n0 0 0\r\n0 "
      "0 0\r\n0 0 0\r\n0 0 0\r\n0 0 0\r\n0 0 0\r\n0 0 0\r\n",
      /* 4 */ "LUT_3D_SIZE 2\r\n" + black(8),
      /* 5 */
      "\n#\n \t\nLUT_3D_SIZE\t2\n0\t0\t0\n0\t0\t0\n0\t0\t0\n0\t0\t0\n0\t0\t0\n0\t0\t0\n0\t0\t0\n0\t0\t0\n\n# TITLE\n",
      /* 6 */ "DOMAIN_MIN -1 -1 -1\nDOMAIN_MAX 0 0 0\nLUT_3D_SIZE 2\n" + black(8),
      // These are none.
      /* 7 */ "\n",
      /* 8 */ black(8),
      /* 9 */ "LUT_3D_SIZE 2\n",
      /* 10 */ "LUT_1D_SIZE 2\n0 0 0\n1 1 1\n",
      /* 11 */ "LUT_1D_SIZE 2\nLUT_3D_SIZE 2\n" + black(8),
      /* 12 */ "LUT_3D_INPUT_RANGE 0 1\nLUT_3D_SIZE 2\n" + black(8),
      /* 13 */ "lut_3d_size 2\n" + black(8),
      /* 14 */ "LUT_3D_SIZE 2\nLUT_3D_SIZE 2\n" + black(8),
      /* 15 */ "TITLE \"a\"\nTITLE \"a\"\nLUT_3D_SIZE 2\n" + black(8),
      /* 16 */ "DOMAIN_MIN 0 0 0\nDOMAIN_MIN 0 0 0\nLUT_3D_SIZE 2\n" + black(8),
      /* 17 */ "DOMAIN_MAX 1 1 1\nDOMAIN_MAX 1 1 1\nLUT_3D_SIZE 2\n" + black(8),
      /* 18 */ black(8) + "LUT_3D_SIZE 2\n",
      /* 19 */ "LUT_3D_SIZE 2\n" + black(8) + "TITLE \"a\"\n",
      /* 20 */ "LUT_3D_SIZE 2\n0 0 0\nDOMAIN_MAX 2 2 2\n" + black(7),
      /* 21 */ "LUT_3D_SIZE 1\n0 0 0\n",
      /* 22 */ "LUT_3D_SIZE 0\n",
      /* 23 */ "LUT_3D_SIZE -2\n" + black(8),
      /* 24 */ "LUT_3D_SIZE 257\n" + black(8),
      /* 25 */ "LUT_3D_SIZE 2.5\n" + black(8),
      /* 26 */ "LUT_3D_SIZE two\n" + black(8),
      /* 27 */ "LUT_3D_SIZE\n" + black(8),
      /* 28 */ "LUT_3D_SIZE 2 2\n" + black(8),
      /* 29 */ "LUT_3D_SIZE 2\n" + black(7),
      /* 30 */ "LUT_3D_SIZE 2\n" + black(9),
      /* 31 */ "LUT_3D_SIZE 3\n" + black(8),
      /* 32 */ "LUT_3D_SIZE 2\n" + black(7) + "0 0\n",
      /* 33 */ "LUT_3D_SIZE 2\n0 0 0 0\n" + black(7),
      /* 34 */ "LUT_3D_SIZE 2\n0 0 0 # first\n" + black(7),
      /* 35 */ "LUT_3D_SIZE 2\n" + black(7) + "0 nan 0\n",
      /* 36 */ "LUT_3D_SIZE 2\n" + black(7) + "0 0 inf\n",
      /* 37 */ "LUT_3D_SIZE 2\n-inf 0 0\n" + black(7),
      /* 38 */ "LUT_3D_SIZE 2\n0 0 red\n" + black(7),
      /* 39 */ "LUT_3D_SIZE 2\n0 0 0.5x\n" + black(7),
      /* 40 */ "LUT_3D_SIZE 2\n0,5 0 0\n" + black(7),
      /* 41 */ "LUT_3D_SIZE 2\n- 0 0\n" + black(7),
      /* 42 */ "DOMAIN_MIN 0 1 0\nLUT_3D_SIZE 2\n" + black(8),
      /* 43 */ "DOMAIN_MAX 1 1 -1\nLUT_3D_SIZE 2\n" + black(8),
      /* 44 */ "DOMAIN_MIN 2 0 0\nDOMAIN_MAX 1 1 1\nLUT_3D_SIZE 2\n" + black(8),
      /* 45 */ "DOMAIN_MIN 0 0\nLUT_3D_SIZE 2\n" + black(8),
      /* 46 */ "DOMAIN_MAX 1 1 1 1\nLUT_3D_SIZE 2\n" + black(8),
      /* 47 */ "DOMAIN_MAX 1 inf 1\nLUT_3D_SIZE 2\n" + black(8),
      /* 48 */ "DOMAIN_MIN nan 0 0\nLUT_3D_SIZE 2\n" + black(8),
      /* 49 */ "TITLE warm\nLUT_3D_SIZE 2\n" + black(8),
      /* 50 */ "TITLE \"warm\nLUT_3D_SIZE 2\n" + black(8),
      /* 51 */ "TITLE\nLUT_3D_SIZE 2\n" + black(8),
      /* 52 */ "TITLE warm \"a\"\nLUT_3D_SIZE 2\n" + black(8),
      /* 53 */ "TITLE \"a\" warm\nLUT_3D_SIZE 2\n" + black(8),
      /* 54 */ "LUT_3D_SIZE 2\n1e999 0 0\n" + black(7),
      /* 55 */ "LUT_3D_SIZE 2\n0x10 0 0\n" + black(7),
      /* 56 */ "LUT_3D_SIZE 2\n0x1p3 0 0\n" + black(7),
      /* 57 */ "LUT_3D_SIZE 2\n0, 0, 0\n" + black(7),
      /* 58 */ "TITLE \"a\"b\"\nLUT_3D_SIZE 2\n" + black(8),
      /* 59 */ "TITLE \"\"\nTITLE \"\"\nLUT_3D_SIZE 2\n" + black(8),
      /* 60 */ "TITLE\"a\"\nLUT_3D_SIZE 2\n" + black(8),
      /* 61 */ "LUT_3D_SIZE 2\n1e 0 0\n" + black(7),
      /* 62 */ "LUT_3D_SIZE 2\n. 0 0\n" + black(7),
      /* 63 */ "LUT_3D_SIZE 2\n1.2.3 0 0\n" + black(7),
  };
  return texts;
}

}  // namespace atelier
