#!/bin/bash
# Tests the packages in a bare Debian that has nothing but its base system:
#   tests/package/in_bare_root.sh PACKAGE.deb MODEL [WHEEL.whl]
# To be run inside of that system, as root, with apt's sources set up: it installs and removes packages. Needs nothing of
# the checkout but what it is given. Ends with "all well", or at the first thing that is wrong with what that is.
set -euo pipefail

fail() { echo "in_bare_root: $1" >&2; exit 1; }

[ $# -ge 2 ] && [ -f "$1" ] && [ -f "$2" ] || fail "give the Debian package and a CAD file (see the head of this script)."
[ "$(id -u)" -eq 0 ] || fail "run this as root of a system that may be changed."
package=$(realpath "$1") model=$(realpath "$2") wheel=${3:+$(realpath "$3")}
export DEBIAN_FRONTEND=noninteractive
out=$(mktemp -d "/tmp/ein Ordner-XXXXXX")
trap 'rm -rf "$out"' EXIT
cd "$out"

install() { apt-get install -y --no-install-recommends "$@" </dev/null >apt.log 2>&1 || { cat apt.log >&2; fail "apt does not install $*."; }; }

# same FILE: what the program wrote first, byte for byte.
same() { [ -s first.msh ] && cmp first.msh "$1" || fail "$1 differs from the program's mesh."; }

# refuses CODE WORDS COMMAND...: ends with that code and one sentence with these words.
refuses() {
  local code=0 expected=$1 words=$2
  shift 2
  "$@" >said.txt 2>&1 || code=$?
  [ "$code" -eq "$expected" ] || fail "'$*' ended with $code, not $expected: $(cat said.txt)"
  [ "$(wc -l <said.txt)" -eq 1 ] && grep -q "$words" said.txt || fail "'$*' says: $(cat said.txt)"
}

apt-get update </dev/null >/dev/null
echo "== the Debian package"
install "$package"
paver --version
paver mesh "$model" --size 20 --quiet -o first.msh --report report.json
[ -s report.json ] || fail "there is no report."
python3 -m paver mesh "$model" --size 20 --quiet -o module.msh
same module.msh
python3 -c "import paver, sys; paver.mesh(sys.argv[1], size=20).write('python.msh'); print(paver.__file__)" "$model"
same python.msh
command -v mpirun >/dev/null || refuses 2 openmpi-bin paver mesh "$model" --size 20 --quiet -o ranks.msh --ranks 2
install openmpi-bin
paver mesh "$model" --size 20 --quiet -o ranks.msh --ranks 2
same ranks.msh
python3 -c "import paver, sys; paver.mesh(sys.argv[1], size=20, ranks=2).write('python2.msh')" "$model"
same python2.msh

apt-get purge -y paver openmpi-bin </dev/null >/dev/null
for left in /usr/bin/paver /usr/lib/paver /usr/lib/python3/dist-packages/paver /usr/share/doc/paver; do
  [ ! -e "$left" ] || fail "$left is left after the package was removed."
done

if [ -n "$wheel" ]; then
  echo "== the wheel"
  apt-get autoremove --purge -y </dev/null >/dev/null
  ! dpkg-query -W -f '${db:Status-Abbrev}${Package}\n' 'libocct*' 'libtbb*' 2>/dev/null | grep '^ii' ||
    fail "libraries are left that the wheel must bring along; this is no bare system."
  install python3-venv
  python3 -m venv bare
  bare/bin/pip install --no-index --no-deps "$wheel" >/dev/null
  bare/bin/paver mesh "$model" --size 20 --quiet -o wheel.msh
  same wheel.msh
  refuses 2 openmpi-bin bare/bin/paver mesh "$model" --size 20 --quiet -o ranks2.msh --ranks 2
  install python3-numpy
  python3 -m venv --system-site-packages numpy
  numpy/bin/pip install --no-index "$wheel" >/dev/null
  numpy/bin/python -c "import paver, sys; paver.mesh(sys.argv[1], size=20).write('wheel2.msh')" "$model"
  same wheel2.msh
  install openmpi-bin
  numpy/bin/paver mesh "$model" --size 20 --quiet -o wheel3.msh --ranks 2
  same wheel3.msh
fi
echo "all well"
