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
};

struct Row {
  std::string work;            ///< "vertex_tangents, 100k triangles"
  std::function<void()> ours;  ///< timed
  Peer peer;
  double aim = 0;  ///< how many times faster than the peer ours should be; 0: no aim
};

/// The whole program: in each of N rounds runs every row's peer and then ours, after one untimed run of each, and
/// writes the seconds as JSON to standard output: {"rows": [{"work", "peer", "aim", "ours": [..], "theirs": [..]}]},
/// with "missing" instead of "theirs" where the peer is. The command line is [N]; default 5. Returns the exit status.
int compare(const std::vector<Row>& rows, int argc, char** argv);

}  // namespace atelier::peers
