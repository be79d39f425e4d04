# Sourced by demo and test: where things are, what to install, how to build.

cd "$(dirname "${BASH_SOURCE[0]}")/.."
# Debian's own Python has the ROS modules; another one earlier on the path has not.
export PATH=/usr/sbin:/usr/bin:/sbin:/bin
export ROS_HOSTNAME=localhost ROS_MASTER_URI="${ROS_MASTER_URI:-http://localhost:11311}"
export ROSCONSOLE_STDOUT_LINE_BUFFERED=1
# A compiler cache serves every checkout, wherever it lies.
export CCACHE_BASEDIR="${CCACHE_BASEDIR:-$PWD}"
build=build

say() { printf '\n== %s\n' "$*"; }

install_packages() {
  local wanted missing=()
  wanted=$(sed 's/#.*//' scripts/apt_packages.txt | awk 'NF {print $1}')
  for package in $wanted; do
    dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || missing+=("$package")
  done
  if [ ${#missing[@]} -eq 0 ]; then
    say "All Debian packages are installed"
    return
  fi
  say "Installing ${#missing[@]} Debian packages: ${missing[*]}"
  local as_root=()
  [ "$(id -u)" -eq 0 ] || as_root=(sudo)
  "${as_root[@]}" apt-get -o DPkg::Lock::Timeout=500 update -q
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get -o DPkg::Lock::Timeout=500 install -y -q --no-install-recommends "${missing[@]}"
}

# configure_tree DIR [CMAKE OPTION...]
configure_tree() {
  local tree=$1
  shift
  # rosrun does not look into a folder "build" of the package, hence devel/ beside it.
  cmake -S . -B "$tree" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCATKIN_DEVEL_PREFIX="$PWD/devel" \
    -DPYTHON_EXECUTABLE=/usr/bin/python3 -DPython3_EXECUTABLE=/usr/bin/python3 "$@"
}

# build_tree DIR [CMAKE OPTION...]: configures it and builds everything
build_tree() {
  configure_tree "$@"
  cmake --build "$1"
}
