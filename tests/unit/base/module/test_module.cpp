extern "C" int atelier_test_answer() {
  return 42;
}
