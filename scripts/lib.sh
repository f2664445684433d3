# Shared functions of the scripts; sourced, never run.
# shellcheck shell=bash disable=SC2034
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

# Uses a compiler cache if there is one. Another folder with the same files then builds from the cache.
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

# Ends with one sentence about bad usage or input, exit status 2.
die() {
  printf '%s: %s\n' "${0##*/}" "$*" >&2
  exit 2
}

# check_port PORT: ends with a sentence unless it is the number of a port.
check_port() {
  if [[ ! $1 =~ ^[1-9][0-9]{0,4}$ ]] || (($1 > 65535)); then die "--port must be 1 .. 65535, got '$1'"; fi
}

# needs COMMAND PURPOSE: ends with a sentence if the command is missing.
needs() { command -v "$1" >/dev/null || die "$1 is missing, $2: install it"; }

# Ends with a sentence if ODE is missing.
needs_ode() { [[ -e /usr/include/ode/ode.h ]] || die "ODE is missing, the second engine for the walk: install libode-dev"; }

# Ends with a sentence if MuJoCo is missing.
needs_mujoco() { [[ -e /usr/include/mujoco/mujoco.h ]] || die "MuJoCo is missing, the physics for the walk: install libmujoco-dev"; }

# Prints the comment at the head of the script, which is its help, and ends the script. A reader may stop before the end.
show_help() { sed -n '2,/^[^#]/{/^#/s/^#[ ]\{0,1\}//p}' "$0" || true; exit 0; }

# Prints the number of compile jobs: one per core, with 1.5 GB of memory each. A file with Beast takes 1.35 GB.
compile_jobs() {
  local jobs memory_kb limit_bytes fitting
  jobs=$(nproc)
  memory_kb=$(awk '/^MemAvailable:/ { print $2 }' /proc/meminfo 2>/dev/null || true)
  # inside a container its own memory limit counts
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

# nao_architecture PRESET: prints Debian's name of this Nao's processor.
nao_architecture() {
  case $1 in
    nao-v6) say amd64 ;;
    nao-v5 | nao-v4) say i386 ;;
    *) die "expected nao-v6, nao-v5 or nao-v4, got '$1'" ;;
  esac
}

# build_alone PRESET TARGET: builds a target of the simulator alone, with another compiler or other flags.
build_alone() {
  mkdir -p "$root/build/$1"
  (cd "$root" && cmake --preset "$1" >"build/$1/configure.log" 2>&1) || { cat "$root/build/$1/configure.log" >&2; return 1; }
  ninja -C "$root/build/$1" -j "$(compile_jobs)" --quiet "$2"
}

# Runs a command with fixed addresses where the kernel allows it. GCC's thread sanitizer refuses to start at addresses that
# it does not expect.
on_fixed_addresses() {
  if setarch "$(uname -m)" -R true 2>/dev/null; then
    setarch "$(uname -m)" -R "$@"
  else
    "$@"
  fi
}

# Prints our C and C++ files, each ended by a NUL character.
all_code() {
  local folder folders=()
  for folder in robot sim tests; do if [[ -d $root/$folder ]]; then folders+=("$folder"); fi; done
  (cd "$root" && find "${folders[@]}" -type f \( -name '*.h' -o -name '*.c' -o -name '*.cpp' \) -print0)
}
