constexpr long hostile_work(long limit) {
  long sum = 0;
  for (long i = 0; i < limit; ++i)
    for (long j = 0; j < 200'000; ++j) sum += i ^ j;
  return sum;
}
constexpr long hostile_number = hostile_work(200'000);
