# What the scripts share; sourced, never run.
# shellcheck shell=bash disable=SC2034
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

# A compiler cache, where there is one: another folder with the same files builds from it.
if command -v ccache >/dev/null && [[ -z ${CMAKE_CXX_COMPILER_LAUNCHER:-} ]]; then
  export CMAKE_C_COMPILER_LAUNCHER=ccache CMAKE_CXX_COMPILER_LAUNCHER=ccache
  export CCACHE_BASEDIR=$root CCACHE_NOHASHDIR=1
fi

say() { printf '%s\n' "$*"; }

# say_duration COMMAND: how long a first run takes, from scripts/durations.txt.
say_duration() {
  local wall processor
  read -r wall processor < <(sed -n "s/^$1  *//p" "$root/scripts/durations.txt")
  say "scripts/$1: a first run takes ${wall/../ to } min on two quiet cores (${processor/../ to } min of processor time)" \
    "plus downloads; the next runs take less."
}

# Reads lines "[3/480] …" of ninja and " 3/480 Test …" of ctest. Prints "NAME: 3 of 480" once a minute, and all other lines.
once_a_minute() {
  local name=$1 every=${FORESIGHT_PROGRESS_SECONDS:-60} line
  local next=$((SECONDS + every))
  while IFS= read -r line; do
    if [[ $line =~ ^\[([0-9]+)/([0-9]+)\]\  || $line =~ ^\ *([0-9]+)/([0-9]+)\ Test\ .*\ Passed\ +[0-9.]+\ sec\ *$ ]]; then
      if ((SECONDS >= next)); then
        say "   $name: ${BASH_REMATCH[1]} of ${BASH_REMATCH[2]}"
        next=$((SECONDS + every))
      fi
    else
      printf '%s\n' "$line"
    fi
  done
}

# Bad usage or input: one sentence for the person who must fix it, exit status 2.
die() {
  printf '%s: %s\n' "${0##*/}" "$*" >&2
  exit 2
}

# The comment at the head of a script is its help: one text, kept where it is read.
show_help() { sed -n '2,/^[^#]/{/^#/s/^#[ ]\{0,1\}//p}' "$0"; }

# Compile jobs that fit: one per core, and 1.5 GB of memory each (a Beast file takes 1.35 GB with debug information).
compile_jobs() {
  local jobs memory_kb limit_bytes fitting
  jobs=$(nproc)
  memory_kb=$(awk '/^MemAvailable:/ { print $2 }' /proc/meminfo 2>/dev/null || true)
  # inside a container its own limit counts, not the machine's memory
  limit_bytes=$(cat /sys/fs/cgroup/memory.max 2>/dev/null || true)
  if [[ $limit_bytes =~ ^[0-9]+$ && -n $memory_kb ]] && ((limit_bytes / 1024 < memory_kb)); then
    memory_kb=$((limit_bytes / 1024))
  fi
  if [[ -n $memory_kb ]]; then
    fitting=$((memory_kb / 1500000))
    if ((fitting < jobs)); then jobs=$fitting; fi
  fi
  if ((jobs < 1)); then jobs=1; fi
  printf '%s\n' "$jobs"
}

# nao_architecture PRESET: what Debian calls the processor of this Nao.
nao_architecture() {
  case $1 in
    nao-v6) say amd64 ;;
    nao-v5 | nao-v4) say i386 ;;
    *) die "expected nao-v6, nao-v5 or nao-v4, got '$1'" ;;
  esac
}

# build_alone PRESET TARGET: of the simulator alone, with another compiler's flags.
build_alone() {
  mkdir -p "$root/build/$1"
  (cd "$root" && cmake --preset "$1" >"build/$1/configure.log" 2>&1) || { cat "$root/build/$1/configure.log" >&2; return 1; }
  ninja -C "$root/build/$1" -j "$(compile_jobs)" --quiet "$2"
}

# Runs a command on fixed addresses where the kernel lets us: GCC's thread sanitizer refuses to start when the kernel
# places a program's parts at addresses it did not foresee.
on_fixed_addresses() {
  if setarch "$(uname -m)" -R true 2>/dev/null; then
    setarch "$(uname -m)" -R "$@"
  else
    "$@"
  fi
}

# Our C and C++ files, each ended by a NUL character.
all_code() {
  local folder folders=()
  for folder in robot sim tests; do if [[ -d $root/$folder ]]; then folders+=("$folder"); fi; done
  (cd "$root" && find "${folders[@]}" -type f \( -name '*.h' -o -name '*.c' -o -name '*.cpp' \) -print0)
}
