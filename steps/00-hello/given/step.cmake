atelier_step(00-hello
  TITLE "Hello, triangle"
  FILES hello.glsl)
