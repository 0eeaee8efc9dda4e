# Sourced by demo.sh, test.sh and .ci/run: installs what is missing of the named sections of packages.txt.
#   need_packages [--no-install] SECTION...
# Does nothing, and asks for no rights, when everything is there.

packages_of() { # the packages of the given sections
  awk -v want=" $* " '/^\[/ {s = substr($0, 2, length($0) - 2); next} /^[^#]/ && NF && index(want, " " s " ")' \
    "$(dirname "${BASH_SOURCE[0]}")/../packages.txt"
}

need_packages() {
  local install=1
  if [ "$1" = --no-install ]; then install=0; shift; fi
  local missing=() name
  for name in $(packages_of "$@"); do
    # Provided names (libegl-dev by libglvnd, for example) count: ask dpkg for an installed package of that name only.
    dpkg-query -W -f '${db:Status-Status}\n' "$name" 2>/dev/null | grep -q '^installed$' || missing+=("$name")
  done
  [ ${#missing[@]} -eq 0 ] && return 0
  local as_root=()
  [ "$(id -u)" -eq 0 ] || as_root=(sudo)
  if [ "$install" -eq 0 ]; then
    echo "Missing packages. Install them with:" >&2
    echo "  ${as_root[*]:+${as_root[*]} }apt-get install --no-install-recommends ${missing[*]}" >&2
    return 3
  fi
  command -v apt-get >/dev/null || { echo "apt-get not found; install by hand: ${missing[*]}" >&2; return 3; }
  echo "Installing ${#missing[@]} packages: ${missing[*]}"
  "${as_root[@]}" apt-get update -qq
  DEBIAN_FRONTEND=noninteractive "${as_root[@]}" apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
}
