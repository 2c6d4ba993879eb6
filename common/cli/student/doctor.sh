# shellcheck shell=bash disable=SC2154 # the launcher assigns these variables
# ./atelier doctor, the part that needs no build. The launcher sources it.
#
# It installs, builds and writes nothing. Each finding is a line: good, note or lack, a subject, words, and the command
# that fixes it, separated by tabs. If the program behind ./atelier is built, it gets these lines, adds what only a
# program can check (OpenGL, display, sandbox, steps) and prints everything.

found=''
finding() { # STATE SUBJECT WORDS [COMMAND]
  found+=$1$'\t'$2$'\t'$3$'\t'${4:-}$'\n'
}

doctor_help() {
  cat <<'TEXT'
./atelier doctor [--json]

What this machine has, what is missing, and the command that fixes it. Installs nothing and builds nothing. Before the
first build it checks compiler, tools and packages; after it also OpenGL, display, sandbox and steps.

  ✓ there    · worth knowing    ✗ needed and missing

Exit status: 0 everything needed is installed, 1 something needed is missing, 2 bad arguments.
TEXT
}

# at_least LEAST VERSION
at_least() {
  [[ $(printf '%s\n' "$1" "$2" | sort -V | head -n 1) == "$1" ]]
}

has_package() {
  case $here in
    debian) installed "$1" ;;
    fedora) rpm -q --whatprovides "$1" >/dev/null 2>&1 ;;
    arch) pacman -T "$1" >/dev/null 2>&1 ;;
  esac
}

# Stores the packages that are not installed in `missing`.
look_for() {
  local package
  missing=()
  for package in "$@"; do has_package "$package" || missing+=("$package"); done
}

# apt has package lists.
apt_has_lists() { compgen -G '/var/lib/apt/lists/*Packages*' >/dev/null; }

# The system's command to install packages; empty if unknown.
install_command() {
  local update=''
  if [[ -z $install ]]; then return; fi
  if [[ $here == debian ]] && ! apt_has_lists; then update="${install_as}apt-get update && "; fi
  echo "$update$install_as$install $*"
}

look_at_system() {
  local PRETTY_NAME=''
  # shellcheck source=/dev/null
  if [[ -r /etc/os-release ]]; then . /etc/os-release; fi
  local kernel tested=''
  kernel=$(uname -srm)
  [[ $kernel == *[Mm]icrosoft* ]] && kernel+=' (WSL)'
  if ! is_release; then tested='; docs/platforms.md lists the tested systems'; fi
  finding good system "${PRETTY_NAME:-unknown}, $kernel$tested"
}

look_at_paths() {
  local complaint
  complaint=$(complaint_about_paths)
  if [[ -n $complaint ]]; then finding lack path "${complaint%: *}" "${complaint##*: }"; fi
}

look_at_compiler() {
  local name compiler='' version
  for name in ${CXX:-} c++ g++ clang++; do
    if command -v "$name" >/dev/null; then
      compiler=$name
      break
    fi
  done
  if [[ -z $compiler ]]; then
    finding lack compiler 'neither c++, g++ nor clang++ is found' "$(install_command "${needed[0]:-}")"
    return
  fi
  version=$("$compiler" --version 2>/dev/null | head -n 1) || true
  # A file of the project that needs no package.
  if ! "$compiler" -std=c++20 -fsyntax-only -I"$root/common" "$root/common/image/scan.cpp" >/dev/null 2>&1; then
    finding lack compiler "$compiler ($version) does not compile this project's C++20: GCC 12 or Clang 14 is needed, or newer" \
      "$(install_command "${needed[0]:-}")"
    return
  fi
  finding good compiler "$version"
}

# look_at_tool NAME LEAST PACKAGE: a program that must be there, in this version or a newer one.
look_at_tool() {
  local name=$1 least=$2 package=$3 version
  if ! command -v "$name" >/dev/null; then
    finding lack "$name" 'not found' "$(install_command "$package")"
    return
  fi
  version=$("$name" --version 2>/dev/null | head -n 1)
  version=${version##* }
  if at_least "$least" "$version"; then
    finding good "$name" "$version"
  else
    finding lack "$name" "$version is too old: $least or newer is needed, from a newer system or from $name's makers"
  fi
}

look_at_packages() {
  if [[ -z $install ]]; then
    packages_of debian
    finding note packages "Atelier does not know those of $here; by their names in Debian it needs: ${needed[*]}"
    return
  fi
  look_for "${needed[@]}"
  if ((${#missing[@]})); then
    finding lack packages "missing: ${missing[*]}" "$(install_command "${missing[@]}")"
  else
    finding good packages 'all that are needed are installed'
  fi
  note_missing 'useful, and missing' "${useful[@]}"
  is_release || note_missing 'missing, and used by ./atelier test alone' "${tests[@]}"
}

# note_missing WORDS PACKAGE...: a note on those that are not there, and one on those that this system does not have.
note_missing() {
  local words=$1 package install_these=() nowhere=()
  shift
  look_for "$@"
  for package in "${missing[@]}"; do
    if [[ $here != debian ]] || ! apt_has_lists || offered "$package"; then
      install_these+=("$package")
    else
      nowhere+=("$package")
    fi
  done
  if ((${#install_these[@]})); then
    finding note packages "$words: ${install_these[*]}" "$(install_command "${install_these[@]}")"
  fi
  if ((${#nowhere[@]})); then finding note packages "useful, but this system has none: ${nowhere[*]}"; fi
}

look_at_build() {
  local words stranger
  stranger=$(strange_build)
  if [[ -n $stranger ]]; then
    finding lack build "$build was moved, or copied from elsewhere, and was made for $stranger" './atelier list'
  elif ! [[ -x $program ]]; then
    finding lack build "not built yet in $build; OpenGL, display, sandbox and steps are looked at once it is" \
      './atelier list'
  elif ! words=$("$program" doctor --help 2>&1); then
    finding lack build "$program does not start: ${words##*$'\n'}" "rm -r ${build@Q} && ./atelier list"
  fi
}

json_text() {
  local text=${1//\\/\\\\}
  printf '"%s"' "${text//\"/\\\"}"
}

print_found_as_json() {
  local state subject words mend between=''
  printf '{\n  "ok": false,\n  "findings": ['
  while IFS=$'\t' read -r state subject words mend; do
    printf '%s\n    {"state": "%s", "subject": "%s", "words": %s, "mend": %s}' "$between" "$state" "$subject" \
      "$(json_text "$words")" "$(json_text "$mend")"
    between=','
  done <<<"${found%$'\n'}"
  printf '\n  ]\n}\n'
}

# As the program prints it (doctor_findings.cpp).
print_found() {
  local state subject words mend
  while IFS=$'\t' read -r state subject words mend; do
    case $state in good) state='✓' ;; note) state='·' ;; lack) state='✗' ;; esac
    printf '%s %-10s %s\n' "$state" "$subject" "$words"
    if [[ -n $mend ]]; then printf '%13sfix: %s\n' '' "$mend"; fi
  done <<<"${found%$'\n'}"
  printf '\nSomething that is needed is missing: see the lines with ✗.\n'
}

doctor() {
  local argument json=()
  for argument in "$@"; do
    case $argument in
      --json) json=(--json) ;;
      -h | --help)
        doctor_help
        return
        ;;
      *) fail "doctor: '$argument' is not allowed; it takes --json" ;;
    esac
  done

  local here program=$build/bin/atelier install_as='' missing=()
  here=$(distribution)
  packages_of "$here"
  if ((EUID != 0)); then install_as='sudo '; fi

  look_at_system
  look_at_paths
  look_at_compiler
  look_at_tool cmake 3.25 "${needed[1]:-}"
  look_at_tool ninja 1.10 "${needed[2]:-}"
  look_at_packages
  look_at_build
  if [[ $found != *$'lack\tbuild\t'* ]]; then
    exec "$program" doctor --found "$found" --install "${install:+$install_as$install}" "${json[@]}"
  fi
  if ((${#json[@]})); then print_found_as_json; else print_found; fi
  return 1
}
