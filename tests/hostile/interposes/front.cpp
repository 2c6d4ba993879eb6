// Definitions that take the place of the library's, of the driver's and of the framework's, where the loader lets them.
extern "C" {
long pwrite64(int, const void*, std::size_t, long) {
  return -1;
}
int rename(const char*, const char*) noexcept {
  return 0;
}
int main() {
  return 0;
}
void glReadPixels() {}
void* atelier_step_program() {
  return nullptr;
}
int memcmp(const void*, const void*, std::size_t) noexcept {
  return 0;
}
}
void* operator new(std::size_t size) {
  return std::calloc(1, size ? size : 1);
}
void operator delete(void*) noexcept {}
void operator delete(void*, std::size_t) noexcept {}
namespace atelier {
struct Case;
bool operator==(const Case&, const Case&) {
  return true;
}
std::string printable(std::string_view text, int) {
  return std::string(text);
}
}  // namespace atelier
HOSTILE_START {
  hostile::attempted("interposes");
}
