#!/usr/bin/env bash
# Installs the Debian package of meniscus in a fresh root of Debian 12, as a user's machine would, and
# runs there: the command, the Python module, programs that find the libraries by pkg-config and by
# find_package. In the end the package is removed and has left nothing. Needs root, debootstrap and
# Debian's archive; ends with 77 where one is missing.
# Usage: clean_root_test.sh FOLDER_OF_PACKAGES SOURCE WORK
# MENISCUS_CLEAN_ROOT, if set, is a root made by debootstrap, which is copied in place of a new one.
set -euo pipefail
packages=$1 source=$2 work=$3

skip() {
    echo "skipped: $1"
    exit 77
}
[ "$(id -u)" = 0 ] || skip "only root can make a root"
command -v debootstrap >/dev/null || [ -n "${MENISCUS_CLEAN_ROOT:-}" ] || skip "debootstrap is missing"
shopt -s nullglob
package=("$packages"/meniscus_*.deb)
[ ${#package[@]} = 1 ] || { echo "expected one package of meniscus in $packages, found ${#package[@]}"; exit 1; }

rm -rf "$work"
mkdir -p "$work"
root=$work/root
if [ -n "${MENISCUS_CLEAN_ROOT:-}" ]; then
    cp -a "$MENISCUS_CLEAN_ROOT" "$root"
else
    debootstrap --variant=minbase bookworm "$root" >"$work/debootstrap.log" 2>&1 ||
        skip "debootstrap failed: $(tail -n 1 "$work/debootstrap.log")"
fi
trap 'rm -rf "$root"' EXIT

# A command in the root, with a /proc of its own; what it prints is shown where it fails.
inside() {
    echo "== $*"
    env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 \
        DEBIAN_FRONTEND=noninteractive OMP_NUM_THREADS=1 \
        unshare --mount --pid --fork --mount-proc="$root/proc" \
        chroot "$root" bash -euo pipefail -c "$*" >"$work/output" 2>&1 ||
        { tail -n 40 "$work/output"; exit 1; }
}

mkdir "$root/try"
cp "${package[0]}" "$root/try/meniscus.deb"
cp -r "$source/examples" "$root/try/examples"
inside "apt-get update -q && apt-get install -q -y --no-install-recommends /try/meniscus.deb"

inside "meniscus --version"
inside "meniscus demo -o /try/demo --quiet && test -s /try/demo/surface_coefficients.hpp"
inside "meniscus label /usr/share/meniscus/samples/droplet_iisph_01.vtkhdf -o /try/out --quiet --report /try/page.html"
inside "meniscus simulate drop_2d --duration 0.05 -o /try/run --quiet"
inside "test -s /usr/share/man/man1/meniscus.1 && test -s /usr/share/bash-completion/completions/meniscus"
inside "cd /try && python3 -c '
import meniscus
state = meniscus.read(\"/usr/share/meniscus/samples/droplet_iisph_01.vtkhdf\")
labels = meniscus.label(state)
stored = meniscus.read(\"/try/out/droplet_iisph_01.vtkhdf\")
assert (labels.uncovered_fraction == stored.arrays[\"uncovered_fraction\"]).all()'"

inside "apt-get install -q -y --no-install-recommends cmake g++ make pkg-config"
inside "cd /try && gcc examples/04_c_interface.c -o c_interface \$(pkg-config --cflags --libs meniscus) -lm && ./c_interface"
inside "cmake -S /try/examples -B /try/build -DCMAKE_BUILD_TYPE=Release && cmake --build /try/build && ctest --test-dir /try/build --output-on-failure"

inside "apt-get purge -q -y meniscus"
inside "! find / -xdev -path /try -prune -o -name '*meniscus*' -print | grep ."
echo "installed, run and removed: ${package[0]##*/}"
