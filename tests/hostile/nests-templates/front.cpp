template <int Depth>
struct HostileChain {
  static constexpr int value = HostileChain<Depth + 1>::value;
};
static const int hostile_number = HostileChain<0>::value;
