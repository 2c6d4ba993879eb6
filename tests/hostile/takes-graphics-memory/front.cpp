// Buffers of 2 GB, three of them.
HOSTILE_START {
  hostile::attempted("takes-graphics-memory");
}
template <class Graphics>
static void hostile_hook(Graphics& gl) {
  static bool done = false;
  if (done) return;
  done = true;
  for (int i = 0; i < 3; ++i) {
    unsigned buffer = 0;
    gl.GenBuffers(1, &buffer);
    gl.BindBuffer(0x8892, buffer);  // GL_ARRAY_BUFFER
    gl.BufferData(0x8892, std::ptrdiff_t(2) << 30, nullptr, 0x88e4);
  }
}
