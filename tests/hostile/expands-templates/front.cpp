// A million instances, about 2 GB.
template <int Depth, unsigned Path>
struct HostileTree : HostileTree<Depth - 1, 2 * Path>, HostileTree<Depth - 1, 2 * Path + 1> {};
template <unsigned Path>
struct HostileTree<0, Path> {};
static const HostileTree<19, 1> hostile_tree;
