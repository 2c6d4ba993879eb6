// Draws without data: indices from nowhere, as many as there can be.
HOSTILE_START {
  hostile::attempted("crashes-driver");
}
template <class Graphics>
static void hostile_hook(Graphics& gl) {
  unsigned array = 0;
  gl.GenVertexArrays(1, &array);
  gl.BindVertexArray(array);
  gl.VertexAttribPointer(0, 4, 0x1406, 0, 16, reinterpret_cast<const void*>(0x10));
  gl.EnableVertexAttribArray(0);
  using Draw = void (*)(unsigned, int, unsigned, const void*);
  if (const auto draw = reinterpret_cast<Draw>(dlsym(nullptr, "glDrawElements")))
    draw(4, 0x7ffffff0, 0x1405, reinterpret_cast<const void*>(0x1000));
}
