# Steps that quickstart and run-tests share; to be sourced from the repository's top folder.

step() { printf '\n== %s (%d min %02d s since start)\n' "$1" $((SECONDS / 60)) $((SECONDS % 60)); }

# install_packages [LIST]: installs the packages of packages.txt, or of that list, that are missing; asks for nothing if there
# is none.
install_packages() {
  local package missing=()
  for package in $(grep -v '^#' "${1:-packages.txt}"); do
    dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null | grep -qx installed || missing+=("$package")
  done
  [ ${#missing[@]} -eq 0 ] && return
  step "Installing ${#missing[@]} Debian packages"
  local root=()
  if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo >/dev/null; then
      echo "These packages are missing, and there is no sudo to install them; run as root:" >&2
      echo "  apt-get install --no-install-recommends ${missing[*]}" >&2
      exit 1
    fi
    root=(sudo)
  fi
  "${root[@]}" apt-get update -q
  "${root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -qy --no-install-recommends "${missing[@]}"
}

# Compilers that may run at a time: one per core, and no more than memory holds.
compile_jobs() {
  local gib_per_compiler=2
  local by_memory=$(($(awk '/MemAvailable/ {print $2}' /proc/meminfo) / 1048576 / gib_per_compiler))
  local jobs
  jobs=$(nproc)
  [ "$by_memory" -lt "$jobs" ] && jobs=$by_memory
  [ "$jobs" -lt 1 ] && jobs=1
  echo "$jobs"
}

# build TARGET...: configures Release in build/ and builds. ASPERITY_NATIVE=OFF leaves out -march=native.
build() {
  step "Configuring"
  cmake --preset release -DASPERITY_NATIVE="${ASPERITY_NATIVE:-ON}"
  step "Building with $(compile_jobs) compilers at a time"
  ninja -C build -j "$(compile_jobs)" "$@"
}
