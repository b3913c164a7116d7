#!/usr/bin/env bash
# Checks the format of what changed, and lints it: C and C++ files that differ from a commit, or that
# Git does not know yet.
# Usage: scripts/check.sh [--fix] [COMMIT]    (--fix formats them; COMMIT: HEAD where none is given)
set -euo pipefail
cd "$(dirname "$0")/.."
format=(--dry-run -Werror)
if [ "${1:-}" = --fix ]; then
    format=(-i)
    shift
fi
for tool in clang-format-14 clang-tidy-14; do
    if ! command -v "$tool" >/dev/null; then
        echo "check.sh: $tool is missing; install Debian's package $tool" >&2
        exit 2
    fi
done
changed=$(git diff --name-only --diff-filter=d "$(git merge-base "${1:-HEAD}" HEAD)")
new=$(git ls-files --others --exclude-standard)
mapfile -t files < <(grep -E '\.(c|h|cpp|hpp)$' <<<"$changed"$'\n'"$new")
if [ ${#files[@]} -eq 0 ]; then
    exit 0
fi
clang-format-14 "${format[@]}" "${files[@]}"
[ -e build/check/compile_commands.json ] || cmake --preset release -B build/check # how each file is compiled
printf '%s\0' "${files[@]}" | xargs -0 -n 1 -P "$(nproc)" clang-tidy-14 --quiet -p build/check
