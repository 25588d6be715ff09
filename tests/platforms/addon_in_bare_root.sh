#!/bin/bash
# Tests the add-on with cores that nobody compiled there, in a bare Debian:
#   tests/platforms/addon_in_bare_root.sh PACKAGE.deb WHEEL.whl
# To be run inside of that system, as root, in a checkout: it installs packages. FreeCAD's own Addon Manager installs the
# add-on; its core comes from the wheel, by the dialog of the first use, and then from the Debian package.
set -euo pipefail
fail() { echo "addon_in_bare_root: $1" >&2; exit 1; }
[ $# -eq 2 ] && [ -f "$1" ] && [ -f "$2" ] || fail "give the Debian package and the wheel (see the head of this script)."
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
package=$(realpath "$1")
export PAVER_WHEEL=$(realpath "$2") CI=true LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive PYTHONDONTWRITEBYTECODE=1

apt-get update -q </dev/null >/dev/null
apt-get install -y --no-install-recommends freecad python3-numpy python3-pyside2.qttest python3-pytest xvfb xauth git python3-git \
  </dev/null >/dev/null
# Not for a compiler: Debian 12's FreeCAD brings one along.
[ ! -e "$root/build" ] && ! command -v cmake || fail "there is a build, or the means for one; this is no bare system."
python3 -m pytest -q -p no:cacheprovider "$root/tests/workbench/first_use_test.py" -k "manager or Binary or a_binary"
apt-get install -y --no-install-recommends "$package" </dev/null >/dev/null
python3 -m pytest -q -p no:cacheprovider "$root/tests/platforms/installed_core_test.py"
echo "all well"
