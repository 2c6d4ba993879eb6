// Times work of a step beside the same work of another package, in one process.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace atelier::peers {

struct Peer {
  std::string name;               ///< "assimp 5.2.5, CalcTangentSpace"
  std::string missing;            ///< the package to install, if the program was built without it; `run` is empty then
  std::function<void()> run;      ///< timed
  std::function<void()> prepare;  ///< called before each run, untimed; may be empty
  std::function<void()> check;  ///< called after each run, untimed; throws Error if the work was not done; may be empty
};

struct Row {
  std::string work;            ///< "vertex_tangents, 100k triangles"
  std::function<void()> ours;  ///< timed
  Peer peer;
  double aim = 0;  ///< how many times faster than the peer ours should be; 0: no aim
};

/// The whole program. For each row runs ours and the peer in each of N rounds, in alternating order, after one untimed
/// run of each, and writes the seconds as JSON to standard output:
/// {"rows": [{"work", "peer", "aim", "ours": [..], "theirs": [..]}]}, with "missing" instead of "theirs" where the peer
/// is. The command line is [N]; default 5. Returns the exit status: 2 for another command line, 1 with a message where
/// anything throws.
int compare(const std::function<std::vector<Row>()>& make_rows, int argc, char** argv);

}  // namespace atelier::peers
