// In printed text, in an exception's text and in the name of its type.
template <char... Letters>
struct HostileName {};
HOSTILE_START {
  hostile::attempted("escapes-in-words");
  hostile::say(
      "\x1b[2J\x1b]0;owned\x07<script>alert('atelier-hostile')</script>\r\b\x9b"
      "31m\xe2\x80\xae=1+1\n");
}
static void hostile_hook() {
  static int calls = 0;
  if (++calls % 2) throw HostileName<'<', 's', 'c', 'r', 'i', 'p', 't', '>', '\x1b'>();
  throw std::runtime_error(
      "</td></script><script>alert('atelier-hostile')</script>\x1b[31m]]><img src=x onerror=alert(1)>"
      "\xff\xfe\xe2\x80\xae");
}
